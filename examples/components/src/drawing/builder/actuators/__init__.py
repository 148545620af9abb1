from .pen import Pen
from .brush import Brush
