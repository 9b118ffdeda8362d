"""Controllers of ros2_control for a HyQ that `farrier ros` shows. Read from the documentation of ROS 2, not run.

ros2 launch ./hyq.launch.py urdf:=hyq.urdf
"""

import pathlib

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

HERE = pathlib.Path(__file__).resolve().parent


def with_control(urdf, tag):
    """The URDF with the <ros2_control> tag as the last child of its robot."""
    tag = tag[tag.index("<ros2_control"):]
    end = urdf.rindex("</robot>")
    return urdf[:end] + tag + urdf[end:]


def nodes(context):
    urdf = pathlib.Path(LaunchConfiguration("urdf").perform(context)).read_text()
    description = with_control(urdf, (HERE / "hyq.ros2_control.xml").read_text())
    return [
        Node(
            package="robot_state_publisher",
            executable="robot_state_publisher",
            parameters=[{"robot_description": description}],
            remappings=[("joint_states", "/hyq/joint_states")],
        ),
        Node(
            package="controller_manager",
            executable="ros2_control_node",
            parameters=[{"robot_description": description}, str(HERE / "controllers.yaml")],
            # Humble reads its own parameter, later nodes the topic of robot_state_publisher.
            remappings=[("~/robot_description", "/robot_description")],
        ),
        Node(package="controller_manager", executable="spawner", arguments=["joint_trajectory_controller"]),
    ]


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("urdf", default_value="hyq.urdf", description="as `farrier robot urdf` writes it"),
        OpaqueFunction(function=nodes),
    ])
