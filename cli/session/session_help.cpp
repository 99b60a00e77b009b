#include <algorithm>
#include <array>

#include "cli/session/interpreter.h"

namespace thiessen::cli {
namespace {

struct Entry {
  const char* name;
  const char* arguments;
  const char* text;
};

constexpr std::array<Entry, 16> entries = {{
    {"add", " X Y [Z]", "a point; points are numbered from 1 in the order they come"},
    {"delete", " X Y [Z]", "the point at this very place"},
    {"undo", "", "take the last add, delete or load back; without limit"},
    {"redo", "", "make what was undone again"},
    {"nearest", " X Y [Z]", "print the nearest point; of equally near ones the lowest number"},
    {"cell", " X Y [Z]", "print the Voronoi cell of the point at this very place"},
    {"load", " FILE", "add the points of a CSV, x,y[,z], or take in what was saved"},
    {"save", " FILE", "write what print does, to be loaded again"},
    {"print", " [FILE]", "the points and the Voronoi vertices, as text"},
    {"cells", " FILE", "a CSV, a row a cell: point, area (3-D: volume), sides"},
    {"export", " FILE", "triangles or tetrahedra: .obj, .ply, in 2-D .geojson"},
    {"show", " FILE.png", "a picture"},
    {"watch", " FILE.png|off", "a picture, now and anew after each change; off ends it"},
    {"check", "", "prove the tessellation sound, or say where it is not"},
    {"help", "", "these lines, on a terminal"},
    {"quit", "", "end, as the end of the input does"},
}};

constexpr const char* formats =
    "\nprint writes a line a point and a line a vertex, and nothing else:\n"
    "  point ID X Y [Z]\n"
    "  vertex ID center X Y [Z] radius R forming F1 F2 F3 [F4] neighbors N1 N2 N3 [N4]\n"
    "Neighbor Ni lies across from forming point Fi; it is 0 where there is none.\n"
    "A table that is loaded where there are no points prints the same lines again, the\n"
    "numbers of points and vertices included. Where there are points already, new ones\n"
    "keep their numbers if none of these was given before, else they are numbered on.\n"
    "cells writes `point,area,sides` (`point,volume,sides` in 3-D), one row a point, inf\n"
    "where the cell is unbounded; sides are its edges, in 3-D its faces. export writes in\n"
    "2-D the triangles, by GeoJSON with the properties a, b and c, the points' numbers;\n"
    "in 3-D four faces a tetrahedron, and in .obj also the bounded cells, each a group.\n"
    "nearest prints a point's line. cell prints it too, and then\n"
    "  vertex ID center X Y [Z] radius R     in 2-D counter-clockwise\n"
    "  ray from ID direction DX DY [DZ]      edges that never end\n"
    "  face neighbor ID area A vertices ...  in 3-D alone, counter-clockwise from outside\n"
    "  area A (volume V in 3-D)              infinity where the cell is unbounded\n"
    "  neighbors ...                         points whose cells share an edge (a face)\n"
    "check prints `sound: N points, M vertices, dimension D`, D of what the points span.\n"
    "show and watch take --size W, WxH or, with --dpi N, WxHmm; in 2-D the window\n"
    "--window XMIN,YMIN,XMAX,YMAX; in 3-D --view X,Y,Z and --site X,Y,Z, from where to\n"
    "where one looks. Where the picture of watch cannot be written, the change is taken\n"
    "back. print FILE, save, cells, export, show and watch replace the file.\n"
    "Ctrl-C at the keyboard drops the line, or the command with all that it did.\n"
    "Blank lines and what follows a # are passed over; a name with blanks stands in\n"
    "quotes.\n";

}  // namespace

std::vector<std::string> session_commands() {
  std::vector<std::string> names;
  names.reserve(entries.size());
  for (const Entry& entry : entries) names.emplace_back(entry.name);
  return names;
}

std::string session_help() {
  constexpr std::size_t column = 22;
  std::string text;
  for (const Entry& entry : entries) {
    std::string line = "  " + std::string(entry.name) + entry.arguments;
    line.resize(std::max(column, line.size() + 1), ' ');
    text += line + entry.text + "\n";
  }
  return text + formats;
}

}  // namespace thiessen::cli
