from .robotproperties import RobotProperties
