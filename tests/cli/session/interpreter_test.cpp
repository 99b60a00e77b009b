#include "cli/session/interpreter.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <sstream>

#include "base/complaints.h"
#include "base/interrupt.h"
#include "base/number.h"
#include "base/temporary_folder.h"

namespace thiessen::cli {
namespace {

using Lines = std::vector<std::string>;

/// What stands for a picture: its size, how many points it shows, and where its window begins.
std::vector<unsigned char> written_down(const PlotSize& size, std::size_t points,
                                        const std::string& from) {
  const std::string text = std::to_string(size.width) + "x" + std::to_string(size.height) + ", " +
                           std::to_string(points) + " points" + from;
  return {text.begin(), text.end()};
}
std::vector<unsigned char> of_plane(const Tessellation<2>& tessellation, const NumberOf&,
                                    const std::optional<PlaneWindow>& window,
                                    const PlotSize& size) {
  return written_down(size, tessellation.count(),
                      window ? " from " + shortest_text(window->low.x) : "");
}
std::vector<unsigned char> of_space(const Tessellation<3>& tessellation, const NumberOf&,
                                    const std::optional<View>& view, const PlotSize& size) {
  return written_down(size, tessellation.count(),
                      view ? " seen from " + shortest_text(view->view.x) : "");
}

/// A session whose answers go to a file.
class Session {
 public:
  explicit Session(std::size_t dimension = 2, bool is_terminal = false)
      : output_("out", open_descriptor(folder.path("out"), O_WRONLY | O_CREAT, 0600),
                OutputFile::Care::closed),
        interpreter_(make_interpreter(
            dimension, {output_, warnings, is_terminal, false, {}, {of_plane, of_space}})) {}

  bool perform(const std::string& line) { return interpreter_->perform(line); }
  void perform_all(const Lines& lines) {
    for (const std::string& line : lines) EXPECT_TRUE(perform(line)) << line;
  }
  std::string complaint(const std::string& line) {
    return complaint_of([&] { perform(line); });
  }
  /// What was answered since the last time.
  std::string answer() {
    output_.flush();
    const std::string all = folder.read("out");
    std::string fresh = all.substr(told_);
    told_ = all.size();
    return fresh;
  }
  /// The answer to one line.
  std::string answer(const std::string& line) {
    perform(line);
    return answer();
  }
  std::size_t faults() const { return interpreter_->faults(); }

  TemporaryFolder folder;
  Warnings warnings;

 private:
  OutputFile output_;
  std::unique_ptr<Interpreter> interpreter_;
  std::size_t told_ = 0;
};

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

// A triangle of 3, 4 and 5: its circle has the middle of the longest side for its centre.
TEST(Interpreter, prints_points_and_vertices) {
  Session session;
  session.perform_all({"add 0 0", "add 4 0", "add 0 3"});
  EXPECT_EQ(session.answer(), "") << "off a terminal only what is asked for is answered";
  const std::string table = session.answer("print");
  EXPECT_TRUE(table.starts_with("point 1 0 0\npoint 2 4 0\npoint 3 0 3\n")) << table;
  EXPECT_TRUE(contains(table, "vertex 1 center 2 1.5 radius 2.5 forming ")) << table;
  EXPECT_TRUE(table.ends_with(" neighbors 0 0 0\n")) << table;
  session.perform("print '" + session.folder.path("a b") + "'");
  EXPECT_EQ(session.folder.read("a b"), table);
}

// Nine points of a square lattice: the cell of the one in the middle is a square.
TEST(Interpreter, tells_a_cell_and_the_nearest_point) {
  Session session;
  for (const char* y : {"0", "2", "4"}) {
    for (const char* x : {"0", "2", "4"}) session.perform(std::string("add ") + x + " " + y);
  }
  const std::string cell = session.answer("cell 2 2");
  EXPECT_TRUE(contains(cell, "area 4\n")) << cell;
  EXPECT_TRUE(contains(cell, "neighbors ")) << cell;
  std::istringstream numbers(cell.substr(cell.find("neighbors ") + 10));
  std::vector<int> neighbours;
  for (int number = 0; numbers >> number;) neighbours.push_back(number);
  std::sort(neighbours.begin(), neighbours.end());
  EXPECT_EQ(neighbours, (std::vector<int>{2, 4, 6, 8}));
  EXPECT_TRUE(contains(session.answer("cell 0 0"), "area inf"));
  EXPECT_EQ(session.answer("nearest 2.9 3.1"), "point 8 2 4\n");
  EXPECT_EQ(session.answer("nearest 1 1"), "point 1 0 0\n") << "of equally near ones the first";
}

TEST(Interpreter, takes_back_and_makes_again) {
  Session session;
  session.perform_all({"add 1 2", "add 3 4", "undo"});
  EXPECT_EQ(session.answer("print"), "point 1 1 2\n");
  session.perform("redo");
  EXPECT_EQ(lines_of(session.answer("print")), 2U);
  session.perform_all({"delete 1 2", "undo", "undo", "add 5 6"});
  EXPECT_EQ(session.answer("print"), "point 1 1 2\npoint 2 5 6\n") << "undo took the number back";
  EXPECT_EQ(session.complaint("redo"), "there is nothing to redo");
}

TEST(Interpreter, loads_points_as_one_step_and_tells_of_equal_ones) {
  Session session;
  session.perform("add 0 0");
  session.perform("load " + session.folder.write("p.csv", "x,y\n1,2\n0,0\n1,2\n2,4\n"));
  EXPECT_EQ(lines_of(session.answer("print")), 3U);
  const auto warned = sentences_of(session.warnings);
  ASSERT_EQ(warned.size(), 2U);
  EXPECT_TRUE(warned[0].ends_with("1 point equals an earlier one in it, and is passed over"));
  EXPECT_TRUE(warned[1].ends_with("1 point was there before, and is passed over"));
  session.perform("undo");
  EXPECT_EQ(session.answer("print"), "point 1 0 0\n");
  EXPECT_THROW(session.perform("print " + session.folder.path("p.csv")), Error)
      << "what was read is not replaced";
}

TEST(Interpreter, proves_the_structure_sound) {
  Session plane;
  EXPECT_EQ(plane.answer("check"), "sound: 0 points, 0 vertices, dimension -1\n");
  plane.perform_all({"add 0 0", "add 4 0"});
  EXPECT_EQ(plane.answer("check"), "sound: 2 points, 0 vertices, dimension 1\n");
  plane.perform_all({"add 0 3", "add 5 5"});
  EXPECT_EQ(plane.answer("check"), "sound: 4 points, 2 vertices, dimension 2\n");
  EXPECT_EQ(plane.faults(), 0U);
  Session space(3);
  space.perform_all({"add 0 0 0", "add 1 0 0", "add 0 1 0", "add 0 0 1"});
  EXPECT_EQ(space.answer("check"), "sound: 4 points, 1 vertices, dimension 3\n");
}

TEST(Interpreter, a_command_that_cannot_be_carried_out_changes_nothing) {
  Session session;
  session.perform("add 1 2");
  for (const char* line :
       {"add 1 2", "add 1", "add 1 2 3", "add x 2", "delete 9 9", "cell 9 9", "load",
        "load nowhere.csv", "undo now", "show a.png --view 1,2,3", "'print", "check 1", "quit now"})
    EXPECT_THROW(session.perform(line), Error) << line;
  EXPECT_TRUE(
      session.complaint("ad 1 2").starts_with("there is no command 'ad' | did you mean 'add'?"));
  EXPECT_EQ(session.answer("print"), "point 1 1 2\n");
}

TEST(Interpreter, passes_over_blank_lines_and_comments_and_ends_with_quit) {
  Session session;
  session.perform_all({"", "  \t", "# add 1 2", "add 1 2 # here"});
  EXPECT_EQ(lines_of(session.answer("print")), 1U);
  EXPECT_FALSE(session.perform("quit"));
}

TEST(Interpreter, says_what_each_command_did_on_a_terminal) {
  Session session(2, true);
  EXPECT_EQ(session.answer("add 1 2"), "point 1\n");
  EXPECT_EQ(session.answer("delete 1 2"), "point 1 is deleted\n");
  EXPECT_EQ(session.answer("undo"), "1 point\n");
  EXPECT_EQ(session.answer("redo"), "0 points\n");
  EXPECT_EQ(session.answer("help"), session_help());
  EXPECT_EQ(Session().answer("help"), "");
}

TEST(Interpreter, shows_a_picture_of_what_there_is) {
  Session session;
  const std::string file = session.folder.path("p.png");
  EXPECT_EQ(session.complaint("show " + file), "there are no points to show");
  session.perform_all({"add 0 0", "add 4 0", "add 0 3"});
  session.perform("show " + file);
  EXPECT_EQ(session.folder.read("p.png"), "1600x0, 3 points");
}

TEST(Interpreter, shows_space_from_a_view) {
  Session session(3);
  session.perform("add 0 0 1");
  session.perform("show " + session.folder.path("p.png") + " --view 2.5,3,4 --site 0,0,0");
  EXPECT_EQ(session.folder.read("p.png"), "1600x0, 1 points seen from 2.5");
}

TEST(Interpreter, shows_a_window_in_the_size_it_is_told) {
  Session session;
  session.perform_all({"add 0 0", "add 4 0", "add 0 3"});
  const std::string file = session.folder.path("p.png");
  session.perform("show " + file + " --size 400x300");
  EXPECT_EQ(session.folder.read("p.png"), "400x300, 3 points");
  session.perform("show " + file + " --size 400x300 --window 1,1,2,1.5");
  EXPECT_EQ(session.folder.read("p.png"), "400x300, 3 points from 1");
}

TEST(Interpreter, writes_a_watched_picture_after_each_change) {
  Session session;
  const std::string file = session.folder.path("p.png");
  const std::string points = session.folder.write("p.csv", "x,y\n4,0\n0,3\n5,5\n");
  session.perform("watch " + file + " --size 200x150");
  EXPECT_EQ(session.complaint("show " + file), "there are no points to show");
  std::vector<std::string> pictures{session.folder.read("p.png")};
  for (const std::string& line :
       {std::string("add 0 0"), "load " + points, std::string("delete 0 0"), std::string("undo"),
        std::string("undo"), std::string("redo")}) {
    session.perform(line);
    pictures.push_back(session.folder.read("p.png"));
  }
  const auto of = [](int points) { return "200x150, " + std::to_string(points) + " points"; };
  EXPECT_EQ(pictures, (Lines{of(0), of(1), of(4), of(3), of(4), of(1), of(4)}))
      << "nothing; a point; a load; one less; undo; a load is one step; redo";
  session.perform("watch off");
  session.perform("undo");
  EXPECT_EQ(session.folder.read("p.png"), pictures[6]);
  EXPECT_EQ(session.complaint("watch off"), "nothing is watched");
}

TEST(Interpreter, takes_a_change_back_whose_watched_picture_cannot_be_written) {
  Session session;
  session.perform_all({"add 0 0", "add 1 1", "undo"});
  session.perform("watch " + session.folder.path("p.png"));
  const std::string table = session.answer("print");
  // The picture is in the way of its next one: a folder has its name.
  ASSERT_EQ(::unlink(session.folder.path("p.png").c_str()), 0);
  ASSERT_EQ(::mkdir(session.folder.path("p.png").c_str(), 0700), 0);
  const std::string points = session.folder.write("p.csv", "x,y\n4,0\n0,3\n5,5\n");
  for (const std::string& line : {std::string("add 2 2"), std::string("delete 0 0"),
                                  "load " + points, std::string("undo"), std::string("redo")}) {
    EXPECT_TRUE(
        contains(session.complaint(line), "the change is taken back; watch off ends the pictures"))
        << line;
    EXPECT_EQ(session.answer("print"), table) << line;
  }
  session.perform("watch off");
  session.perform("redo");
  EXPECT_EQ(session.answer("print"), table + "point 2 1 1\n");
}

TEST(Interpreter, watches_what_it_did_where_it_cannot_watch_another) {
  Session session;
  session.perform("watch " + session.folder.path("p.png"));
  const std::string empty = session.folder.read("p.png");
  EXPECT_THROW(session.perform("watch " + session.folder.path("nowhere/p.png")), Error);
  EXPECT_THROW(session.perform("watch on"), Error);
  EXPECT_THROW(session.perform("watch"), Error);
  session.perform("add 1 2");
  EXPECT_NE(session.folder.read("p.png"), empty);
}

TEST(Interpreter, loads_what_it_saved_and_prints_the_same_lines) {
  for (const std::size_t dimension : {2U, 3U}) {
    const std::string z = dimension == 3 ? " 0" : "";
    Session session(dimension);
    session.perform_all({"add 0 0" + z, "add 4 0" + z, "add 0 3" + z, "add 9 9" + z, "add 5 5" + z,
                         "delete 0 3" + z, "add 1 7" + z, "delete 9 9" + z});
    if (dimension == 3) session.perform_all({"add 0 0 8", "add 3 1 -2", "delete 0 0 8"});
    const std::string table = session.answer("print");
    const std::string file = session.folder.path("saved.txt");
    session.perform("save " + file);
    EXPECT_EQ(session.answer(), "") << "off a terminal nothing is said";
    EXPECT_EQ(session.folder.read("saved.txt"), table);
    Session again(dimension);
    again.perform("load " + file);
    EXPECT_EQ(again.answer("print"), table);
    again.perform("save " + file);
    EXPECT_EQ(session.folder.read("saved.txt"), table) << "saved again where it came from";
    again.perform("undo");
    EXPECT_EQ(again.answer("print"), "");
    EXPECT_TRUE(sentences_of(again.warnings).empty());
  }
}

TEST(Interpreter, tells_what_of_a_saved_session_it_does_not_keep) {
  Session session;
  session.perform_all({"add 0 0", "add 4 0", "add 0 3", "save " + session.folder.path("saved.txt"),
                       "undo", "undo", "undo", "add 7 7",
                       "load " + session.folder.path("saved.txt")});
  const std::string table = session.answer("print");
  EXPECT_TRUE(table.starts_with("point 1 7 7\npoint 2 0 0\npoint 3 4 0\npoint 4 0 3\n")) << table;
  const auto warned = sentences_of(session.warnings);
  ASSERT_EQ(warned.size(), 2U);
  EXPECT_TRUE(warned[0].ends_with(
      "saved.txt: its points are numbered on from 2, for numbers of its own are taken"))
      << warned[0];
  EXPECT_TRUE(
      warned[1].ends_with("saved.txt: its vertices are passed over, for there were points before"))
      << warned[1];
}

TEST(Interpreter, a_saved_session_that_is_cut_changes_nothing) {
  Session session;
  session.perform_all({"add 0 0", "add 4 0", "add 0 3", "add 5 5"});
  const std::string table = session.answer("print");
  Session other;
  const std::string cut = other.folder.write("cut.txt", table.substr(0, table.rfind("vertex")));
  EXPECT_TRUE(contains(other.complaint("load " + cut), "is the file whole?"));
  EXPECT_EQ(other.answer("print"), "");
  EXPECT_TRUE(contains(other.complaint("load " + other.folder.write("p", "point 1 2 3 4\n")),
                       "p:1: the line of a point is `point ID X Y`"));
}

TEST(Interpreter, writes_cells_and_meshes) {
  Session session;
  session.perform_all({"add 0 0", "add 2 0", "add 2 2", "add 0 2", "add 1 1"});
  session.perform("cells " + session.folder.path("cells.csv"));
  EXPECT_EQ(session.folder.read("cells.csv"),
            "point,area,sides\n1,inf,3\n2,inf,3\n3,inf,3\n4,inf,3\n5,2,4\n");
  for (const char* name : {"m.obj", "m.ply", "m.geojson"}) {
    session.perform(std::string("export ") + session.folder.path(name));
    EXPECT_FALSE(session.folder.read(name).empty()) << name;
  }
  EXPECT_EQ(session.answer(), "");
  EXPECT_TRUE(contains(session.complaint("export m.stl"), "no format"));
  EXPECT_TRUE(contains(session.complaint("cells -"), "and not to the standard output"));
  EXPECT_TRUE(contains(session.complaint("save"), "save needs the name of a file"));
  EXPECT_TRUE(sentences_of(session.warnings).empty());
  Session few;
  few.perform_all({"add 0 0", "export " + few.folder.path("m.obj")});
  EXPECT_EQ(sentences_of(few.warnings).size(), 1U) << "no triangles";
}

TEST(Interpreter, hears_ctrl_c_and_changes_nothing) {
  watch_for_interrupts();
  Session session;
  session.perform("add 1 2");
  for (const char* line :
       {"add 3 4", "undo", "print", "check", "save s.txt", "cells c.csv", "export m.obj"}) {
    std::raise(SIGINT);
    EXPECT_THROW(session.perform(line), Interrupted) << line;
    EXPECT_TRUE(forget_ctrl_c());
  }
  EXPECT_EQ(session.answer("print"), "point 1 1 2\n");
}

}  // namespace
}  // namespace thiessen::cli
