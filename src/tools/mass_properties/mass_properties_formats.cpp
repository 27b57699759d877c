#include "tools/mass_properties/mass_properties_formats.hpp"

#include <sstream>

#include <rigid_body_sim/mass/principal_axes.hpp>

#include "math/shortest.hpp"
#include "programs/formatted.hpp"
#include "tools/mass_properties/scene_names.hpp"

namespace rigid_body_sim {
namespace {

/// Ten digits, for people, without a minus before zero.
std::string number(double x) { return formatted("%.10g", x == 0 ? 0.0 : x); }

/// In as few digits as read back as the same number.
std::string exact(double x) { return shortest(x == 0 ? 0.0 : x); }

std::string bracketed(const Vector3d& v) {
  return "[" + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + "]";
}

/// "x, y, z" for the separator ", "
std::string exactNumbers(const Vector3d& v, const std::string& separator) {
  return exact(v.x()) + separator + exact(v.y()) + separator + exact(v.z());
}

std::string text(const NamedMass& body) {
  const MassProperties& m = body.mass;
  const PrincipalAxes axes = principalAxes(m.I_Bcm);
  std::ostringstream lines;
  lines << body.name << (body.remark.empty() ? "" : ": " + body.remark) << "\n"
        << "  mass               " << number(m.mass) << " kg\n"
        << "  centre of mass     " << bracketed(m.com_B) << " m in the body frame\n"
        << "  inertia            " << bracketed(m.I_Bcm.row(0))
        << " kg m^2 about the centre of mass, in body axes\n"
        << "                     " << bracketed(m.I_Bcm.row(1)) << "\n"
        << "                     " << bracketed(m.I_Bcm.row(2)) << "\n"
        << "  principal moments  " << bracketed(axes.I) << " kg m^2\n"
        << "  principal axes     " << bracketed(axes.R_BP.col(0)) << " in the body frame\n"
        << "                     " << bracketed(axes.R_BP.col(1)) << "\n"
        << "                     " << bracketed(axes.R_BP.col(2)) << "\n";
  return lines.str();
}

/// The six entries of an inertia, each written by entry(name, value).
template <class Entry>
std::string inertiaEntries(const Matrix3d& I, const std::string& separator, const Entry& entry) {
  const auto at = [&](int row, int column) { return exact(I(row, column)); };
  return entry("ixx", at(0, 0)) + separator + entry("iyy", at(1, 1)) + separator +
         entry("izz", at(2, 2)) + separator + entry("ixy", at(0, 1)) + separator +
         entry("ixz", at(0, 2)) + separator + entry("iyz", at(1, 2));
}

/// What a comment says of a body that goes by another name in a scene.
std::string renamed(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  return name + " in the file";
}

/// scene_name: the body's own, or one that a scene accepts in its place.
std::string yaml(const NamedMass& body, const std::string& scene_name) {
  const auto entry = [](const std::string& name, const std::string& value) {
    return name + ": " + value;
  };
  std::ostringstream lines;
  const std::string remark = scene_name == body.name ? body.remark : renamed(body.name);
  lines << "  - name: " << scene_name << (remark.empty() ? "" : "  # " + remark) << "\n"
        << "    mass: " << exact(body.mass.mass) << "\n"
        << "    center_of_mass: [" << exactNumbers(body.mass.com_B, ", ") << "]\n"
        << "    inertia: {" << inertiaEntries(body.mass.I_Bcm, ", ", entry) << "}\n";
  return lines.str();
}

/// Bodies as a scene accepts them; only the links of a robot may have names that it does not.
std::string yaml(const std::vector<NamedMass>& masses) {
  std::vector<std::string> names;
  names.reserve(masses.size());
  for (const NamedMass& body : masses) names.push_back(body.name);
  const std::vector<std::string> accepted = sceneNamesOfLinks(names);
  std::string all = "bodies:\n";
  for (std::size_t i = 0; i < masses.size(); ++i) all += yaml(masses[i], accepted[i]);
  return all;
}

/// A name as an XML comment can hold it.
std::string commented(std::string name) {
  for (std::size_t i = name.find("--"); i != std::string::npos; i = name.find("--"))
    name.insert(i + 1, " ");
  return name;
}

std::string urdf(const NamedMass& body) {
  const auto entry = [](const std::string& name, const std::string& value) {
    return name + "=\"" + value + "\"";
  };
  std::ostringstream lines;
  lines << "<!-- " << commented(body.name + (body.remark.empty() ? "" : ": " + body.remark))
        << " -->\n<inertial>\n"
        << "  <origin xyz=\"" << exactNumbers(body.mass.com_B, " ") << "\" rpy=\"0 0 0\"/>\n"
        << "  <mass value=\"" << exact(body.mass.mass) << "\"/>\n"
        << "  <inertia " << inertiaEntries(body.mass.I_Bcm, " ", entry) << "/>\n</inertial>\n";
  return lines.str();
}

}  // namespace

std::string formatted(const std::vector<NamedMass>& masses, MassFormat format) {
  if (format == MassFormat::kYaml) return yaml(masses);
  std::string all;
  for (const NamedMass& body : masses) all += format == MassFormat::kText ? text(body) : urdf(body);
  return all;
}

}  // namespace rigid_body_sim
