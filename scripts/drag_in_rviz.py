#!/usr/bin/env python3
"""Drags the box of the scene free_space, which demo_pusher keeps on a round, with a true mouse in rviz,
without a screen of its own, and takes the picture of doc/node.md half way. Fails when the box does not
come to the mouse.

usage: source .build/devel/setup.bash && scripts/drag_in_rviz.py doc/images/demo.png
Needs xvfb, xdotool and imagemagick. It is no test: it waits by the clock until rviz has drawn.
"""

import math
import os
import subprocess
import sys
import time

import rosgraph
import rospkg
import rospy
from rigid_body_sim.srv import GetState, Step
from std_srvs.srv import SetBool

DISPLAY = ':77'
PORT = 11377
SIZE = (1280, 800)
VIEW = (364, 62, 900, 709)  # where rviz draws in a window of that size: left, top, width, height
FOCUS, DISTANCE, YAW, PITCH = (0.0, 0.0, 1.3), 5.6, 0.9, 0.45  # as in config/rviz/scene.rviz
FIELD = math.pi / 4  # of view, from top to bottom [rad]
GOAL = (814, 190)  # of the mouse [pixels]: above the round that the box flies
PAUSE = 0.5  # [s] after each action of the mouse, for rviz to see it


def pixel_of(point):
    """Where rviz draws a point of the world."""
    sy, cy, sp, cp = math.sin(YAW), math.cos(YAW), math.sin(PITCH), math.cos(PITCH)
    x, y, z = (p - f for p, f in zip(point, FOCUS))
    depth = DISTANCE - (x * cy * cp + y * sy * cp + z * sp)
    right, up = -x * sy + y * cy, -x * cy * sp - y * sy * sp + z * cp
    left, top, width, height = VIEW
    scale = height / (2 * math.tan(FIELD / 2)) / depth
    return round(left + width / 2 + scale * right), round(top + height / 2 - scale * up)


def run(*command):
    subprocess.run(command, check=True)


def mouse(*command):
    run('xdotool', *map(str, command))
    time.sleep(PAUSE)


def wait_for_rviz():
    master = rosgraph.Master('/drag_in_rviz')
    for _ in range(60):
        time.sleep(1)
        try:
            subscribers = dict(master.getSystemState()[1])
        except (OSError, rosgraph.MasterException):
            continue
        if '/rviz' in subscribers.get('/rigid_body_node/push/update', []):
            return
    sys.exit('rviz has not come up within a minute')


def drag(picture):
    """Returns by how many pixels the box is off the mouse, at first and in the end."""
    pause = rospy.ServiceProxy('/rigid_body_node/pause', SetBool)
    step = rospy.ServiceProxy('/rigid_body_node/step', Step)
    get_state = rospy.ServiceProxy('/rigid_body_node/get_state', GetState)
    wait_for_rviz()
    time.sleep(12)  # for rviz to come up, and for a trail
    pause(True)
    time.sleep(2)

    place = get_state('box', 'world').pose.position
    start = pixel_of((place.x, place.y, place.z))
    mouse('mousemove', *start)
    mouse('mousedown', 1)
    for i in range(1, 6):
        mouse('mousemove', *(s + i * (g - s) // 5 for s, g in zip(start, GOAL)))
    step(100)
    time.sleep(1)
    run('import', '-window', 'root', picture)
    for _ in range(20):
        step(100)
        time.sleep(0.2)
    place = get_state('box', 'world').pose.position
    mouse('mouseup', 1)
    return math.dist(start, GOAL), math.dist(pixel_of((place.x, place.y, place.z)), GOAL)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    os.environ.update(DISPLAY=DISPLAY, LIBGL_ALWAYS_SOFTWARE='1',
                      ROS_MASTER_URI=f'http://localhost:{PORT}')
    screen = subprocess.Popen(['Xvfb', DISPLAY, '-screen', '0', f'{SIZE[0]}x{SIZE[1]}x24'])
    scene = rospkg.RosPack().get_path('rigid_body_sim') + '/config/scenes/free_space.yaml'
    launch = subprocess.Popen(['roslaunch', '-p', str(PORT), 'rigid_body_sim', 'sim.launch',
                               f'scene:={scene}'])
    pusher = subprocess.Popen(['rosrun', 'rigid_body_sim', 'demo_pusher'])
    try:
        before, after = drag(sys.argv[1])
    finally:
        pusher.terminate()
        launch.send_signal(subprocess.signal.SIGINT)
        launch.wait()
        screen.terminate()
    print(f'the box was {before:.0f} pixels off the mouse, and is {after:.0f}')
    # the mouse holds the box at its skin, by which its centre stays off
    sys.exit(after > before / 2)


if __name__ == '__main__':
    main()
