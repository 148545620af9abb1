from .syrotek import Syrotek
