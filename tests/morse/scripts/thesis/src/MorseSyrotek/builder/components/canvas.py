from morse.builder import *

class Canvas(PassiveObject):

    def __init__(
        self, filename, alpha = 1, prefix = None, keep_pose = False
    ):
        PassiveObject.__init__(self, filename, prefix, keep_pose)

        mat = bpymorse.get_material("CanvasMat")
        if alpha >= 1.0:
            mat.use_transparency = False
        else:
            mat.use_transparency = True
            mat.alpha = alpha
