from .pen import Pen
