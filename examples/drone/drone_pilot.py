#!/usr/bin/env python3
"""Flies the quadrotor of config/scenes/quadrotor.yaml along a circle, as drone_pilot.cpp does."""
from math import atan2, cos, sin, sqrt

import rospy
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState

ROTORS = {'front_left': (1, 1, 1), 'rear_left': (-1, 1, -1),  # in front, on the left, ccw: +1
          'rear_right': (-1, -1, 1), 'front_right': (1, -1, -1)}
ARM, MASS, INERTIA = 0.17, 1.2, (0.0095, 0.0105, 0.018)  # [m], [kg], [kg m^2]
THRUST, DRAG_TORQUE = 8.5e-6, 1.4e-7  # over speed squared
RADIUS, HEIGHT, RATE = 1.5, 1.0, 1.2  # of the circle: [m], [m], [rad/s]
HOVER, SPEED_UP = 2.0, 2.0  # [s] before the circle, and up to full speed
DAMPING, PATH_RATE, TURN_RATES = 0.9, 2.5, (10, 10, 2)  # of the control law; [rad/s]
DELAY = 0.01  # [s] from a measured state to the instant at which its commands take effect


def circle(t):
    """Position, velocity and acceleration wanted at time t [s]."""
    t = max(t - HOVER, 0.0)
    early = t < SPEED_UP
    angle = RATE * (t * t / (2 * SPEED_UP) if early else t - SPEED_UP / 2)
    rate = RATE * min(t / SPEED_UP, 1.0)
    change = RATE / SPEED_UP if early and t > 0 else 0.0
    c, s = RADIUS * cos(angle), RADIUS * sin(angle)
    return (c, s, HEIGHT), (-rate * s, rate * c, 0), (-change * s - rate**2 * c,
                                                      change * c - rate**2 * s, 0)


def axes(q):
    """Axes of the body in the world: columns of its rotation matrix."""
    x, y, z, w = q.x, q.y, q.z, q.w
    return ((1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)),
            (2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)),
            (2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)))


def dot(a, b):
    return sum(i * j for i, j in zip(a, b))


def speeds(t, odometry):
    """Speeds of the rotors [rad/s]; the law stands in circle_pilot.hpp."""
    p, R = odometry.pose.pose.position, axes(odometry.pose.pose.orientation)
    u, w = odometry.twist.twist.linear, odometry.twist.twist.angular
    v = [dot((u.x, u.y, u.z), row) for row in zip(*R)]
    x_path, v_path, a_path = circle(t)
    a = [a_path[i] + 2 * DAMPING * PATH_RATE * (v_path[i] - v[i])
         + PATH_RATE**2 * (x_path[i] - (p.x, p.y, p.z)[i]) + (0, 0, 9.80665)[i] for i in range(3)]
    e = (-dot(a, R[1]) / sqrt(dot(a, a)), dot(a, R[0]) / sqrt(dot(a, a)), -atan2(R[0][1], R[0][0]))
    torque = [INERTIA[i] * (TURN_RATES[i]**2 * e[i] - 2 * DAMPING * TURN_RATES[i] * (w.x, w.y, w.z)[i])
              for i in range(3)]
    shares = [MASS * dot(a, R[2]) + (left * torque[0] - front * torque[1]) / ARM
              - turn * torque[2] * THRUST / DRAG_TORQUE for front, left, turn in ROTORS.values()]
    return [sqrt(max(share / 4, 0) / THRUST) for share in shares]


class Pilot:
    def __init__(self):
        self.start = None
        self.command = rospy.Publisher('quadrotor/command', JointState, queue_size=10, tcp_nodelay=True)
        rospy.Subscriber('quadrotor/odom', Odometry, self.on_odometry, tcp_nodelay=True)

    def on_odometry(self, odometry):
        now = odometry.header.stamp
        if self.start is None or now < self.start:  # earlier: time was set back
            self.start = now
        message = JointState(name=list(ROTORS))
        message.header.stamp = now + rospy.Duration(DELAY)
        message.velocity = speeds((now - self.start).to_sec(), odometry)
        self.command.publish(message)


if __name__ == '__main__':
    rospy.init_node('drone_pilot')
    pilot = Pilot()
    rospy.spin()
