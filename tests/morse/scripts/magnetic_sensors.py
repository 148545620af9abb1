from morse.builder import *

robot = ATRV()
robot.rotate(z=0.5)

magnetometer = Magnetometer()
robot.append(magnetometer)
in_2017 = Magnetometer()
in_2017.properties(date=2017.5)
robot.append(in_2017)

imu = IMU()
imu.translate(z=0.3)
robot.append(imu)
noisy = IMU()
noisy.alter('Noise', gyro_std=0.01, accel_std=0.2)
robot.append(noisy)

motion = MotionVW()
robot.append(motion)
robot.add_default_interface('socket')

env = Environment('empty', fastmode=True)
env.properties(longitude=1.5, latitude=43.6, altitude=150.0, angle_against_north=90.0)
