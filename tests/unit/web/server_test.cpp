#include "tests/unit/web/client.hpp"

#include <chrono>
#include <thread>

#include "tools/web/access.hpp"

namespace farrier::web {
namespace server_test {

using namespace std::chrono_literals;
using monitor::testing::Feed;
using testing::client;
using testing::serve;
using testing::stream;

TEST(Access, TellsItsOwnNamesFromThoseOfOthers) {
  for (const char* ours : {"localhost", "LocalHost:8642", "127.0.0.1:1", "[::1]:8642", "127.0.0.1"}) {
    EXPECT_TRUE(host_is_ours(ours, true, "robot")) << ours;
    EXPECT_TRUE(host_is_ours(ours, false, "robot")) << ours;
  }
  for (const char* theirs : {"", "evil.example", "localhost.evil.example", "127.0.0.1.evil.example", "[::1", "[evil]:1",
                             "[::1].evil.example", "evil.example:127.0.0.1"}) {
    EXPECT_FALSE(host_is_ours(theirs, true, "robot")) << theirs;
    EXPECT_FALSE(host_is_ours(theirs, false, "robot")) << theirs;
  }
  for (const char* elsewhere : {"192.168.1.5:8642", "robot", "robot.local:8642", "[fe80::1]"}) {
    EXPECT_FALSE(host_is_ours(elsewhere, true, "robot")) << elsewhere;
    EXPECT_TRUE(host_is_ours(elsewhere, false, "robot")) << elsewhere;
  }
}

TEST(Access, FindsItsCookieAmongOthers) {
  EXPECT_EQ(cookie("a=1; farrier_80=x; b=2", "farrier_80"), "x");
  EXPECT_EQ(cookie("farrier_800=y", "farrier_80"), "");
  EXPECT_EQ(cookie("xfarrier_80=y", "farrier_80"), "");
  EXPECT_EQ(cookie("", "farrier_80"), "");
}

TEST(Access, MakesTokensThatDiffer) {
  EXPECT_EQ(random_token().size(), 32u);
  EXPECT_NE(random_token(), random_token());
  EXPECT_TRUE(equal("ab", "ab"));
  EXPECT_FALSE(equal("ab", "ac"));
  EXPECT_FALSE(equal("ab", ""));
}

TEST(WebServer, ServesThePageWithHeadersThatKeepOthersOut) {
  const auto display = serve();
  const auto answer = client(*display).Get("/");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  EXPECT_EQ(answer->body, "<p>page</p>");
  EXPECT_EQ(answer->get_header_value("Content-Type"), "text/html; charset=utf-8");
  EXPECT_NE(answer->get_header_value("Content-Security-Policy").find("default-src 'self'"), std::string::npos);
  EXPECT_EQ(answer->get_header_value("X-Content-Type-Options"), "nosniff");
  EXPECT_EQ(answer->get_header_value("Cross-Origin-Resource-Policy"), "same-origin");
  EXPECT_FALSE(answer->has_header("Access-Control-Allow-Origin"));
}

TEST(WebServer, ServesNothingButItsFiles) {
  const auto display = serve();
  for (const char* path : {"/nothing", "/../main.js", "/..%2fetc%2fpasswd", "//etc/passwd", "/api", "/api/frames/"}) {
    const auto answer = client(*display).Get(path);
    ASSERT_TRUE(answer) << path;
    EXPECT_EQ(answer->status, 404) << path;
  }
}

TEST(WebServer, CanOnlyBeRead) {
  const auto display = serve();
  EXPECT_EQ(client(*display).Post("/api/robot")->status, 405);
  EXPECT_EQ(client(*display).Delete("/")->status, 405);
  EXPECT_EQ(client(*display).Options("/")->status, 405);
}

TEST(WebServer, RefusesANameThatIsNotThisComputers) {
  const auto display = serve();
  EXPECT_EQ(client(*display).Get("/api/robot", {{"Host", "evil.example"}})->status, 421);
  EXPECT_EQ(client(*display).Get("/api/robot", {{"Host", "localhost:9"}})->status, 200);
}

TEST(WebServer, NeedsNoTokenOnThisComputerAlone) {
  EXPECT_EQ(serve()->url().find("token"), std::string::npos);
}

TEST(WebServer, AsksForItsTokenBeyondThisComputer) {
  const auto display = serve("0.0.0.0");
  const std::string token = display->url().substr(display->url().find("token=") + 6);
  ASSERT_EQ(token.size(), 32u);
  EXPECT_EQ(client(*display).Get("/")->status, 401);
  EXPECT_EQ(client(*display).Get("/api/frames")->status, 401);
  EXPECT_EQ(client(*display).Get("/?token=" + std::string(32, '0'))->status, 401);
  const auto let_in = client(*display).Get("/?token=" + token);
  EXPECT_EQ(let_in->status, 302);
  EXPECT_EQ(let_in->get_header_value("Location"), "/");
  const std::string set = let_in->get_header_value("Set-Cookie");
  EXPECT_NE(set.find("HttpOnly"), std::string::npos);
  EXPECT_EQ(client(*display).Get("/", {{"Cookie", set.substr(0, set.find(';'))}})->status, 200);
  EXPECT_EQ(client(*display).Get("/", {{"Cookie", "farrier_1=" + token}})->status, 401);
}

TEST(WebServer, RefusesAnAddressThatIsTaken) {
  const auto display = serve();
  const auto second = WebDisplay::create({"127.0.0.1", static_cast<std::uint16_t>(display->port()), false},
                                         testing::small_page(), testing::hyq());
  ASSERT_FALSE(second.ok());
  EXPECT_NE(second.error().message.find("in use"), std::string::npos) << second.error().message;
}

TEST(WebServer, StreamsWhatWasBeforeAndWhatComes) {
  const auto display = serve();
  Feed feed;
  feed.walk(0, 1);
  display->show(feed.frame());
  std::thread robot([&] {
    std::this_thread::sleep_for(100ms);
    feed.walk(20, 1);
    display->show(feed.frame());
  });
  const std::string text = stream(*display, 2);
  robot.join();
  EXPECT_NE(text.find("-1\ndata: {"), std::string::npos);
  EXPECT_NE(text.find("-2\ndata: {"), std::string::npos);
}

TEST(WebServer, GoesOnWhereAPageStopped) {
  const auto display = serve();
  Feed feed;
  for (int i = 0; i < 3; ++i) {
    display->show(feed.frame());
  }
  const std::string before = stream(*display, 1);
  const std::string life = before.substr(before.find("id: ") + 4, 8);
  const std::string text = stream(*display, 1, {{"Last-Event-ID", life + "-2"}});
  EXPECT_EQ(text.find("-1\ndata"), std::string::npos);
  EXPECT_NE(text.find("-3\ndata"), std::string::npos);
  EXPECT_NE(stream(*display, 1, {{"Last-Event-ID", "0badc0de-2"}}).find("-1\ndata"), std::string::npos);
}

TEST(WebServer, TellsAPageThatWasTooSlowWhatItMissed) {
  const auto display = serve();
  Feed feed;
  feed.view().note(signals::Severity::kError, "in a frame that is gone", feed.now_ns());
  for (int i = 0; i < 300; ++i) {
    display->show(feed.frame());
  }
  const std::string text = stream(*display, 2);
  EXPECT_NE(text.find("event: gap\ndata: {\"frames\":100,"), std::string::npos) << text.substr(0, 200);
  EXPECT_NE(text.find("in a frame that is gone"), std::string::npos);
}

TEST(WebServer, WaitsForNoPageThatDoesNotRead) {
  const auto display = serve();
  httplib::Client idle = client(*display);
  std::atomic<bool> open = false, done = false;
  std::thread page([&] {
    idle.Get("/api/frames", [&](const char*, std::size_t) {
      open = true;
      while (!done) {
        std::this_thread::sleep_for(5ms);
      }
      return false;
    });
  });
  Feed feed;
  monitor::testing::walk_for_a_second(feed);
  display->show(feed.frame());
  for (int i = 0; i < 200 && !open; ++i) {
    std::this_thread::sleep_for(5ms);
  }
  ASSERT_TRUE(open);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 1000; ++i) {  // eight megabytes: more than sockets take
    display->show(feed.frame());
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
  EXPECT_EQ(client(*display).Get("/api/robot")->status, 200);
  done = true;
  page.join();
}

TEST(WebServer, EndsWithinASecondWhileAPageWatches) {
  auto display = serve();
  std::atomic<bool> heard = false;
  std::thread page([&display = *display, &heard] {
    client(display).Get("/api/frames", [&](const char*, std::size_t) { return heard = true; });
  });
  for (int i = 0; i < 200 && !heard; ++i) {
    std::this_thread::sleep_for(5ms);
  }
  const auto begin = std::chrono::steady_clock::now();
  display.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 1s);
  page.join();
}

TEST(WebServer, ServesNoMorePagesThanItHasThreadsFor) {
  const auto display = serve();
  std::atomic<bool> done = false;
  std::atomic<int> open = 0;
  std::vector<std::thread> pages;
  for (int i = 0; i < 8; ++i) {
    pages.emplace_back([&] {
      bool first = true;
      client(*display).Get("/api/frames", [&](const char*, std::size_t) {
        open += std::exchange(first, false) ? 1 : 0;
        return !done;
      });
    });
  }
  for (int i = 0; i < 400 && open < 8; ++i) {
    std::this_thread::sleep_for(5ms);
  }
  EXPECT_EQ(open, 8);
  EXPECT_EQ(client(*display).Get("/api/frames")->status, 503);
  EXPECT_EQ(client(*display).Get("/")->status, 200);
  done = true;
  for (std::thread& page : pages) {
    page.join();
  }
}

}  // namespace server_test
}  // namespace farrier::web
