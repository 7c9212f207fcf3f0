// SPDX-License-Identifier: MIT
// A headless Chromium, driven as a user does it: by the DevTools protocol over a pipe
// (https://chromedevtools.github.io/devtools-protocol/, --remote-debugging-pipe).
#pragma once
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>
#include "core/json.hpp"

namespace texel::test {

class Browser {
 public:
  /// `program` is Chromium, `profile` an empty folder for what it keeps.
  Browser(const std::string& program, const std::filesystem::path& profile) {
    int to_browser[2], from_browser[2];
    if (::pipe2(to_browser, O_CLOEXEC) != 0 || ::pipe2(from_browser, O_CLOEXEC) != 0)
      throw std::runtime_error("no pipes");
    const std::string own_profile = "--user-data-dir=" + profile.string();
    child_ = ::fork();
    if (child_ == 0) {
      // It reads from descriptor 3 and writes to 4, which may be ends of the pipes themselves.
      const int in = ::fcntl(to_browser[0], F_DUPFD, 10), out = ::fcntl(from_browser[1], F_DUPFD, 10);
      const int null = ::open("/dev/null", O_RDWR);
      ::dup2(in, 3);
      ::dup2(out, 4);
      ::dup2(null, 1);
      ::dup2(null, 2);
      ::setpgid(0, 0);
      ::execl(program.c_str(), program.c_str(), "--headless", "--no-sandbox", "--disable-gpu",
              // A page that is taken for hidden draws no frames, and a mouse's event waits for one.
              "--disable-backgrounding-occluded-windows", "--disable-renderer-backgrounding",
              "--disable-background-timer-throttling", "--disable-dev-shm-usage", "--remote-debugging-pipe",
              own_profile.c_str(), "about:blank", nullptr);
      ::_exit(127);
    }
    ::close(to_browser[0]);
    ::close(from_browser[1]);
    in_ = from_browser[0];
    out_ = to_browser[1];
    ::signal(SIGPIPE, SIG_IGN);
    const std::string target = call("Target.createTarget", {{"url", "about:blank"}})["targetId"];
    session_ = call("Target.attachToTarget", {{"targetId", target}, {"flatten", true}})["sessionId"];
    for (const char* domain : {"Page", "Runtime", "Network", "Log"}) call(std::string(domain) + ".enable");
    call("Page.bringToFront");
  }
  ~Browser() {
    ::kill(-child_, SIGKILL);  // with its helpers
    ::waitpid(child_, nullptr, 0);
    ::close(in_);
    ::close(out_);
  }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// Opens a file of this machine and waits until it is loaded.
  void open(const std::filesystem::path& file) {
    call("Page.navigate", {{"url", "file://" + std::filesystem::absolute(file).string()}});
    wait_for("document.readyState === 'complete'");
  }

  /// What a JavaScript expression gives; of a promise, what it is kept with.
  Json evaluate(const std::string& expression) {
    const Json answer = call("Runtime.evaluate",
                             {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
    if (answer.contains("exceptionDetails"))
      throw std::runtime_error(expression + ": " + to_text(answer["exceptionDetails"]));
    return answer["result"].value("value", Json());
  }

  /// Waits until an expression is true, 20 seconds at most.
  void wait_for(const std::string& expression) {
    const bool came =
        evaluate("new Promise(done => { const end = Date.now() + 20000; const look = () => (" + expression +
                 ") ? done(true) : Date.now() > end ? done(false) : "
                 "setTimeout(look, 10); look(); })");
    if (!came) throw std::runtime_error("in vain: " + expression);
  }

  /// Presses and releases a key, as a hand does: "ArrowLeft", "Tab", "+", "Shift+ArrowLeft".
  void press(std::string name) {
    const bool shift = name.starts_with("Shift+");
    if (shift) name.erase(0, 6);
    const std::map<std::string, int> codes = {{"Tab", 9},         {"Enter", 13},     {"End", 35},
                                              {"Home", 36},       {"ArrowLeft", 37}, {"ArrowUp", 38},
                                              {"ArrowRight", 39}, {"ArrowDown", 40}};
    Json event = {{"type", "keyDown"}, {"key", name}, {"modifiers", shift ? 8 : 0}};
    if (const auto found = codes.find(name); found != codes.end()) {
      event["windowsVirtualKeyCode"] = found->second;
      event["code"] = name;
    }
    if (name.size() == 1) event["text"] = name;
    if (name == "Enter") event["text"] = "\r";
    call("Input.dispatchKeyEvent", event);
    event["type"] = "keyUp";
    event.erase("text");
    call("Input.dispatchKeyEvent", event);
  }
  void type(const std::string& text) { call("Input.insertText", {{"text", text}}); }

  /// Moves, presses or releases the left button, or turns the wheel, at a point of the window.
  void mouse(const std::string& type, double x, double y, double wheel = 0) {
    Json event = {{"type", type},
                  {"x", x},
                  {"y", y},
                  {"button", type == "mouseWheel" ? "none" : "left"},
                  {"clickCount", 1}};
    if (type == "mouseWheel") event.update({{"deltaX", 0}, {"deltaY", wheel}});
    if (type == "mouseMoved") event["button"] = "none";
    call("Input.dispatchMouseEvent", event);
  }

  /// A window, or a phone.
  void resize(int width, int height, bool phone = false) {
    call("Emulation.setDeviceMetricsOverride",
         {{"width", width}, {"height", height}, {"deviceScaleFactor", phone ? 2 : 1}, {"mobile", phone}});
  }
  void prefer(const std::string& scheme) {
    call("Emulation.setEmulatedMedia",
         {{"features", Json::array({{{"name", "prefers-color-scheme"}, {"value", scheme}}})}});
  }

  /// Addresses that were asked for, and complaints: uncaught errors and what a page was forbidden.
  [[nodiscard]] const std::vector<std::string>& requests() const { return requests_; }
  [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }
  void forget() {
    requests_.clear();
    complaints_.clear();
  }

 private:
  Json call(const std::string& method, const Json& parameters = Json::object()) {
    Json message = {{"id", ++last_}, {"method", method}, {"params", parameters}};
    if (!session_.empty()) message["sessionId"] = session_;
    const std::string text = to_text(message) + '\0';
    for (std::size_t sent = 0; sent < text.size();) {
      const ssize_t count = ::write(out_, text.data() + sent, text.size() - sent);
      if (count <= 0) throw std::runtime_error("the browser has gone");
      sent += static_cast<std::size_t>(count);
    }
    while (true) {
      const Json answer = receive();
      note(answer);
      if (answer.value("id", 0) != last_) continue;
      if (answer.contains("error")) throw std::runtime_error(method + ": " + to_text(answer["error"]));
      return answer["result"];
    }
  }

  void note(const Json& event) {
    const std::string method = event.value("method", "");
    if (method == "Network.requestWillBeSent") requests_.push_back(event["params"]["request"]["url"]);
    if (method == "Runtime.exceptionThrown")
      complaints_.push_back(to_text(event["params"]["exceptionDetails"]));
    if (method == "Log.entryAdded" && event["params"]["entry"]["level"] == "error")
      complaints_.push_back(event["params"]["entry"]["text"]);
  }

  Json receive() {
    std::size_t end;
    while ((end = received_.find('\0')) == std::string::npos) {
      pollfd ready = {in_, POLLIN, 0};
      std::array<char, 65536> block{};
      if (::poll(&ready, 1, 60'000) <= 0) throw std::runtime_error("the browser says nothing");
      const ssize_t count = ::read(in_, block.data(), block.size());
      if (count <= 0) throw std::runtime_error("the browser did not start or has gone");
      received_.append(block.data(), static_cast<std::size_t>(count));
    }
    Json message = parse_json(received_.substr(0, end));
    received_.erase(0, end + 1);
    return message;
  }

  pid_t child_ = -1;
  int in_ = -1, out_ = -1, last_ = 0;
  std::string received_, session_;
  std::vector<std::string> requests_, complaints_;
};

}  // namespace texel::test
