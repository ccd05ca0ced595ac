// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/io/atomic_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/files.h"
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace posture {
namespace {

namespace fs = std::filesystem;
using test::bytesOf;
using test::inputErrorOf;
using test::TemporaryFolder;
using ::testing::HasSubstr;

TEST(AtomicFile, appearsOnCommitAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "out.txt";
  AtomicFile file(path);
  file.stream() << "text";
  EXPECT_FALSE(fs::exists(path));
  file.commit();
  EXPECT_EQ(bytesOf(path), "text");
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(AtomicFile, cannotBeSeenBeforeCommit) {
  const TemporaryFolder folder;
  AtomicFile file(folder.path() / "out.txt");
  file.stream() << "text" << std::flush;
  EXPECT_EQ(folder.names().size(), 0u);
}

TEST(AtomicFile, replacesAnotherFile) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("out.txt", "a longer text");
  AtomicFile file(path);
  file.stream() << "new";
  file.commit();
  EXPECT_EQ(bytesOf(path), "new");
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(WriteFile, replacesTheWholeFileWithTheseBytes) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("out.txt", "a longer text");
  writeFile(path, std::string_view("new\0\n", 5));
  EXPECT_EQ(bytesOf(path), std::string("new\0\n", 5));
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(AtomicFile, aSignalLeavesNothing) {
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    const TemporaryFolder folder;
    const fs::path path = folder.file("out.txt", "old");
    const auto interrupted = [&] {
      std::signal(SIGINT, SIG_DFL);  // ignored where a shell runs the tests in the background
      AtomicFile file(path);
      file.stream() << std::string(100000, 'x') << std::flush;
      std::raise(signal);
    };
    EXPECT_EXIT(interrupted(), testing::KilledBySignal(signal), "");
    EXPECT_EQ(bytesOf(path), "old");
    EXPECT_EQ(folder.names().size(), 1u);
  }
}

TEST(AtomicFile, withoutCommitTheOldFileStays) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("out.txt", "old");
  { AtomicFile(path).stream() << "new"; }
  EXPECT_EQ(bytesOf(path), "old");
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(AtomicFile, twoAtOnceDoNotMeet) {
  const TemporaryFolder folder;
  AtomicFile first(folder.path() / "out.txt"), second(folder.path() / "out.txt");
  first.stream() << "first";
  second.stream() << "second";
  second.commit();
  first.commit();
  EXPECT_EQ(bytesOf(folder.path() / "out.txt"), "first");
}

TEST(AtomicFile, whatARunBeforeLeftIsInNobodysWay) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("out.txt", "old");
  const std::string process = ".posture-" + std::to_string(::getpid()) + "-";
  for (int i = 0; i < 100; ++i) folder.file(process + std::to_string(i) + ".tmp", "left");
  writeFile(path, "new");
  EXPECT_EQ(bytesOf(path), "new");
  EXPECT_EQ(folder.names().size(), 101u);
  EXPECT_EQ(bytesOf(folder.path() / (process + "99.tmp")), "left");
}

TEST(AtomicFile, aFileWrittenOverHandsDownItsPermissions) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("out.txt", "old");
  for (const fs::perms permissions : {fs::perms(0600), fs::perms(0664)}) {
    fs::permissions(path, permissions);
    writeFile(path, "new");
    EXPECT_EQ(fs::status(path).permissions(), permissions);
  }
}

TEST(AtomicFile, handsDownOwnersAndNoRightToRunAsThem) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root may give files away";
  const TemporaryFolder folder;
  const fs::path path = folder.file("out.txt", "old");
  ASSERT_EQ(::chown(path.c_str(), 12345, 54321), 0);
  ASSERT_EQ(::chmod(path.c_str(), 04660), 0);
  writeFile(path, "new");
  struct stat after {};
  ASSERT_EQ(::stat(path.c_str(), &after), 0);
  EXPECT_EQ(after.st_uid, 12345u);
  EXPECT_EQ(after.st_gid, 54321u);
  EXPECT_EQ(after.st_mode & 07777U, 0660u);
}

TEST(AtomicFile, writesThroughALink) {
  const TemporaryFolder folder;
  const fs::path path = folder.file("out.txt", "old"), link = folder.path() / "link.txt";
  fs::create_symlink(path, link);
  AtomicFile file(link);
  file.stream() << "new";
  file.commit();
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(bytesOf(path), "new");
}

TEST(AtomicFile, writesWhatALinkPointsToThoughItIsNotThere) {
  const TemporaryFolder folder;
  const fs::path link = folder.path() / "link.txt", second = folder.path() / "second.txt";
  fs::create_directory(folder.path() / "deep");
  fs::create_symlink("second.txt", link);
  fs::create_symlink("deep/out.txt", second);
  writeFile(link, "new");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(fs::is_symlink(second));
  EXPECT_EQ(bytesOf(folder.path() / "deep" / "out.txt"), "new");
}

TEST(AtomicFile, refusesLinksThatLeadNowhere) {
  const TemporaryFolder folder;
  const fs::path loop = folder.path() / "loop.txt", lost = folder.path() / "lost.txt";
  fs::create_symlink("loop.txt", loop);
  fs::create_symlink("no/out.txt", lost);
  EXPECT_THAT(inputErrorOf([&] { writeFile(loop, "new"); }), HasSubstr("too many links"));
  EXPECT_THAT(inputErrorOf([&] { writeFile(lost, "new"); }),
              HasSubstr("no/out.txt: cannot be written: No such file"));
  EXPECT_TRUE(fs::is_symlink(loop) && fs::is_symlink(lost));
}

TEST(AtomicFile, saysWhyAPlaceCannotBeWritten) {
  const TemporaryFolder folder;
  const fs::path missing = folder.path() / "no" / "out.txt";
  EXPECT_THAT(inputErrorOf([&] { AtomicFile file(missing); }),
              HasSubstr(missing.string() + ": cannot be written: No such file"));
  EXPECT_THAT(inputErrorOf([&] { AtomicFile file(folder.path()); }), HasSubstr("is a folder"));
  EXPECT_THAT(inputErrorOf([&] { AtomicFile file("/dev/null"); }), HasSubstr("not a regular file"));
}

TEST(AtomicFile, worksInTheCurrentFolder) {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  AtomicFile file("out.txt");
  file.stream() << "text";
  file.commit();
  fs::current_path(before);
  EXPECT_EQ(bytesOf(folder.path() / "out.txt"), "text");
}

TEST(AtomicFile, aFullDiskFailsAndLeavesNothing) {
  const TemporaryFolder folder;
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit small{1000, old.rlim_max};
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = inputErrorOf([&] {
    AtomicFile file(folder.path() / "out.txt");
    file.stream() << std::string(100000, 'x');
    file.commit();
  });
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_THAT(message, HasSubstr("out.txt: cannot be written: "));
  EXPECT_EQ(folder.names().size(), 0u);
}

}  // namespace
}  // namespace posture
