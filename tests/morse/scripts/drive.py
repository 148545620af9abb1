from morse.builder import *

class MyEnv():
    def setUpEnv(self):
        robot = ATRV()
        robot.translate(-5.0, 2.0, 0.0)

        pose = Pose()
        pose.translate(x=0.3, z=0.5)
        robot.append(pose)

        odometry = Odometry()
        robot.append(odometry)

        motion = MotionVW()
        robot.append(motion)

        scanner = Sick()
        scanner.translate(z=0.5)
        robot.append(scanner)

        waypoint = Waypoint()
        waypoint.properties(ObstacleAvoidance=False)
        robot.append(waypoint)

        quiet = Pose()
        robot.append(quiet)

        for component in (pose, odometry, motion, scanner):
            component.add_stream('socket')
            component.add_service('socket')
        waypoint.add_service('socket')

        env = Environment('empty', fastmode=True)
        env.add_service('socket')

MyEnv().setUpEnv()
