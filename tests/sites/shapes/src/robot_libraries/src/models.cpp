// Reads robot descriptions.
#include <angles/angles.h>
#include <urdf/model.h>

#include <cstdio>

namespace
{
constexpr char ARM[] = R"(
<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial>
    <mass value="2.5"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
  </inertial></link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="upper"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1.5707963267948966" effort="30" velocity="1"/>
  </joint>
</robot>)";
}  // namespace

int main()
{
  urdf::Model model;
  std::printf("a joint without a parent: %d\n", model.initString(R"(<robot name="bad">
    <link name="base"/><joint name="loose" type="fixed"><child link="base"/></joint></robot>)"));
  std::printf("no such file: %d\n", model.initFile("/ros/share/robot_libraries/gone.urdf"));
  if (!model.initString(ARM)) {
    return 1;
  }
  const auto joint = model.getJoint(JOINT);
  std::printf("%s has %zu links, root %s\n", model.getName().c_str(), model.links_.size(),
    model.getRoot()->name.c_str());
  std::printf("%s turns to %g degrees\n", JOINT, angles::to_degrees(joint->limits->upper));
  std::printf("%s weighs %g kg\n", joint->child_link_name.c_str(),
    model.getLink(joint->child_link_name)->inertial->mass);
  double turn = 0;
  const bool allowed = angles::shortest_angular_distance_with_limits(-0.5, 0.5, 0.25, -0.25, turn);
  std::printf("the other way around: %d, %.4f\n", allowed, turn);
}
