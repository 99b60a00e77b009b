#include "base/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <thread>

#include "base/fed_pipe.h"
#include "base/interrupt.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

std::string sentence_of(const std::string& file) {
  try {
    InputFile input(file);
    std::array<char, 10> bytes;
    input.read(bytes);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::string read_all(InputFile input) {
  std::string all;
  std::array<char, 7> bytes;
  while (const std::size_t count = input.read(bytes)) all.append(bytes.data(), count);
  return all;
}

TEST(InputFile, reads_a_file_to_its_end) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_all(InputFile(folder.write("a", "a text of some blocks"))),
            "a text of some blocks");
  EXPECT_EQ(read_all(InputFile(folder.write("b", ""))), "");
}

TEST(InputFile, knows_the_size_of_plain_files) {
  const TemporaryFolder folder;
  EXPECT_EQ(InputFile(folder.write("a", "21 bytes in this file")).size(), 21u);
  EXPECT_EQ(InputFile("/dev/zero").size(), 0u);
}

TEST(InputFile, says_with_the_systems_words_what_cannot_be_read) {
  const TemporaryFolder folder;
  EXPECT_EQ(sentence_of(folder.path("no")),
            folder.path("no") + ": cannot open: No such file or directory");
  EXPECT_EQ(sentence_of(folder.path()), folder.path() + ": cannot read: Is a directory");
  EXPECT_EQ(sentence_of(""), "the name of an input is empty");
  const std::string long_name(5000, 'n');
  EXPECT_EQ(sentence_of(long_name), long_name + ": cannot open: File name too long");
  const std::string loop = folder.path("loop");
  ASSERT_EQ(::symlink("loop", loop.c_str()), 0);
  EXPECT_EQ(sentence_of(loop), loop + ": cannot open: Too many levels of symbolic links");
  if (::geteuid() != 0) {
    const std::string closed = folder.write("closed", "x");
    ::chmod(closed.c_str(), 0);
    EXPECT_EQ(sentence_of(closed), closed + ": cannot open: Permission denied");
  }
}

TEST(InputFile, reads_files_of_proc_whose_size_is_0) {
  EXPECT_NE(read_all(InputFile("/proc/self/status")).find("Name:"), std::string::npos);
}

TEST(InputFile, reads_a_named_pipe_whose_writer_is_slow) {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const int end = ::open(pipe.c_str(), O_WRONLY);
    for (const char* text : {"time,A\n", "1,2\n"}) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      EXPECT_GT(::write(end, text, std::char_traits<char>::length(text)), 0);
    }
    ::close(end);
  });
  EXPECT_EQ(read_all(InputFile(pipe)), "time,A\n1,2\n");
  writer.join();
}

TEST(InputFile, waits_for_a_writer_that_has_nothing_to_say_yet) {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] {
    const int end = ::open(pipe.c_str(), O_WRONLY);
    std::this_thread::sleep_for(
        std::chrono::milliseconds(3500));  // longer than a missing writer gets
    EXPECT_EQ(::write(end, "x", 1), 1);
    ::close(end);
  });
  EXPECT_EQ(read_all(InputFile(pipe)), "x");
  writer.join();
}

TEST(InputFile, does_not_hang_on_a_named_pipe_without_a_writer) {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(sentence_of(pipe), pipe + ": cannot read: nobody writes to this pipe");
}

TEST(InputFile, is_woken_by_an_interrupt) {
  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  watch_for_interrupts();
  InputFile input("/dev/fd/" + std::to_string(ends[0]));
  const pthread_t reader = ::pthread_self();
  std::thread sender([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ::pthread_kill(reader, SIGINT);
    std::this_thread::sleep_for(std::chrono::seconds(1));  // a read that was not woken sees the end
    ::close(ends[1]);
  });
  std::array<char, 10> bytes;
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THROW(input.read(bytes), Interrupted);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(900));
  forget_interrupt();
  sender.join();
  ::close(ends[0]);
}

TEST(OutputFile, writes_more_than_its_buffer_holds_in_order) {
  const TemporaryFolder folder;
  OutputFile file("a", open_descriptor(folder.path("a"), O_WRONLY | O_CREAT, 0600),
                  OutputFile::Care::synced);
  std::string expected;
  for (int i = 0; i < 200'000; ++i) {
    const std::string line = std::to_string(i) + "\n";
    file.append(line);
    expected += line;
  }
  const std::string big(1'000'000, 'x');
  file.append(big);
  file.append("end");
  file.finish();
  EXPECT_TRUE(folder.read("a") == expected + big + "end");
}

TEST(OutputFile, fails_where_the_disk_is_full) {
  OutputFile file("/dev/full", open_descriptor("/dev/full", O_WRONLY), OutputFile::Care::closed);
  file.append("x");
  try {
    file.finish();
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "/dev/full: cannot write: No space left on device");
  }
}

TEST(OutputFile, fails_where_the_reader_has_gone) {
  watch_for_interrupts();
  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  OutputFile file("standard output", Descriptor(ends[1]), OutputFile::Care::closed);
  file.append("x");
  try {
    file.finish();
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "standard output: cannot write: Broken pipe");
  }
}

TEST(OutputFile, waits_for_a_reader_that_is_slow_on_a_pipe_that_does_not_block) {
  int ends[2] = {};
  ASSERT_EQ(::pipe2(ends, O_NONBLOCK), 0);
  std::string got;
  std::thread reader([&] {
    ::fcntl(ends[0], F_SETFL, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::array<char, 5000> bytes;
    for (ssize_t n = 1; n > 0;) {
      n = ::read(ends[0], bytes.data(), bytes.size());
      if (n > 0) got.append(bytes.data(), static_cast<std::size_t>(n));
    }
  });
  const std::string text(500'000, 'x');
  OutputFile file("pipe", Descriptor(ends[1]), OutputFile::Care::closed);
  file.append(text);
  file.finish();
  reader.join();
  EXPECT_TRUE(got == text);
  ::close(ends[0]);
}

TEST(StandardStreams, closed_ones_are_not_taken_by_the_next_file) {
  EXPECT_EXIT(
      {
        ::close(STDIN_FILENO);
        ::close(STDOUT_FILENO);
        hold_standard_streams();
        int wrong = 0;
        try {
          OutputFile out = standard_output();
          out.append("x");
          out.finish();
          wrong |= 1;
        } catch (const Error&) {
        }
        if (sentence_of("-") != "standard input: cannot read: Bad file descriptor") wrong |= 2;
        if (open_descriptor("/dev/null", O_RDONLY).number() <= 2) wrong |= 4;
        ::_exit(wrong);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(OutputFile, hands_held_text_over_when_it_is_finished_and_drops_what_is_discarded) {
  const TemporaryFolder folder;
  OutputFile output("out", open_descriptor(folder.path("out"), O_WRONLY | O_CREAT, 0600),
                    OutputFile::Care::closed);
  output.append("first ");
  output.flush();
  {
    OutputFile never = output.held();
    never.append(std::string(1'000'000, 'x'));
  }
  OutputFile held = output.held();
  held.append("second ");
  held.flush();
  EXPECT_EQ(folder.read("out"), "first ");
  held.finish();
  output.append("dropped ");
  output.discard();
  output.append("third");
  output.finish();
  EXPECT_EQ(folder.read("out"), "first second third");
}

TEST(OutputFile, starts_over_with_nothing_of_what_was_appended) {
  const std::string large(1'000'000, 'x');
  for (const OutputFile::Care care : {OutputFile::Care::synced, OutputFile::Care::held}) {
    for (const std::string& dropped : {std::string("dropped"), large}) {
      const TemporaryFolder folder;
      OutputFile output("out", open_descriptor(folder.path("out"), O_WRONLY | O_CREAT, 0600), care);
      output.append(dropped);
      output.start_over();
      output.append("kept");
      output.finish();
      EXPECT_EQ(folder.read("out"), "kept");
    }
  }
}

TEST(InputFile, knows_whether_a_pipe_has_bytes) {
  FedPipe pipe;
  InputFile file(pipe.path());
  EXPECT_TRUE(file.may_wait());
  EXPECT_FALSE(file.has_bytes(std::chrono::milliseconds(1)));
  pipe.feed("x");
  EXPECT_TRUE(file.has_bytes(std::chrono::milliseconds(0)));
  std::array<char, 4> bytes{};
  EXPECT_EQ(file.read(bytes), 1U);
  EXPECT_FALSE(file.has_bytes(std::chrono::milliseconds(0)));
  pipe.end();
  EXPECT_TRUE(file.has_bytes(std::chrono::milliseconds(0)));
  EXPECT_EQ(file.read(bytes), 0U);
}

TEST(OutputFile, knows_whether_a_pipe_has_a_reader) {
  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  const OutputFile file("standard output", Descriptor(ends[1]), OutputFile::Care::closed);
  EXPECT_FALSE(file.is_reader_gone());
  ::close(ends[0]);
  EXPECT_TRUE(file.is_reader_gone());
}

}  // namespace
}  // namespace thiessen
