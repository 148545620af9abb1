from .canvas import Canvas
