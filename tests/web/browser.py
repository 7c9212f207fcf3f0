# SPDX-License-Identifier: MIT
"""A headless Chromium, driven as a user does it: by the DevTools protocol over a pipe
(https://chromedevtools.github.io/devtools-protocol/, --remote-debugging-pipe)."""
import json
import os
import pathlib
import select
import signal
import subprocess

KEYS = {"Tab": 9, "Enter": 13, "End": 35, "Home": 36, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40}
# A page that is taken for hidden draws no frames, and a mouse's event waits for one.
OPTIONS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-backgrounding-occluded-windows", "--disable-renderer-backgrounding",
           "--disable-background-timer-throttling", "--disable-dev-shm-usage", "--remote-debugging-pipe"]


class Browser:
    def __init__(self, program, profile):
        """`program` is Chromium, `profile` an empty folder for what it keeps."""
        (its_in, self.out), (self.into, its_out) = os.pipe(), os.pipe()
        # It reads from descriptor 3 and writes to 4.
        self.child = subprocess.Popen(["sh", "-c", f'exec "$@" 3<&{its_in} 4>&{its_out}', "sh", program, *OPTIONS, f"--user-data-dir={profile}",
                                       "about:blank"], pass_fds=(its_in, its_out), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                      start_new_session=True)
        os.close(its_in)
        os.close(its_out)
        self.received, self.last, self.session = b"", 0, None
        self.requests = []  # addresses that were asked for
        self.complaints = []  # uncaught errors and what a page was forbidden
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(domain + ".enable")
        self.call("Page.bringToFront")

    def close(self):
        os.killpg(self.child.pid, signal.SIGKILL)  # with its helpers
        self.child.wait()
        os.close(self.into)
        os.close(self.out)

    def call(self, method, **parameters):
        self.last += 1
        message = {"id": self.last, "method": method, "params": parameters, **({"sessionId": self.session} if self.session else {})}
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.out, data):]
        while (answer := self.receive()).get("id") != self.last:
            self.note(answer.get("method"), answer.get("params", {}))
        if "error" in answer:
            raise RuntimeError(f"{method}: {answer['error']}")
        return answer["result"]

    def receive(self):
        while b"\0" not in self.received:
            if not select.select([self.into], [], [], 60)[0]:
                raise RuntimeError("the browser says nothing")
            block = os.read(self.into, 65536)
            if not block:
                raise RuntimeError("the browser did not start or has gone")
            self.received += block
        message, _, self.received = self.received.partition(b"\0")
        return json.loads(message)

    def note(self, method, event):
        if method == "Network.requestWillBeSent":
            self.requests.append(event["request"]["url"])
        if method == "Runtime.exceptionThrown":
            self.complaints.append(json.dumps(event["exceptionDetails"]))
        if method == "Log.entryAdded" and event["entry"]["level"] == "error":
            self.complaints.append(event["entry"]["text"])

    def open(self, file):
        """Opens a file of this machine and waits until it is loaded."""
        self.call("Page.navigate", url=pathlib.Path(file).resolve().as_uri())
        self.wait_for("document.readyState === 'complete'")

    def ask(self, expression):
        """What a JavaScript expression gives; of a promise, what it is kept with."""
        answer = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def act(self, statements):
        self.ask(f"{{ {statements} }} 0")

    def wait_for(self, expression):
        """Waits until an expression is true, 20 seconds at most."""
        if not self.ask(f"""new Promise(done => {{ const end = Date.now() + 20000;
            const look = () => ({expression}) ? done(true) : Date.now() > end ? done(false) : setTimeout(look, 10); look(); }})"""):
            raise RuntimeError(f"in vain: {expression}")

    def press(self, name, times=1):
        """Presses and releases a key, as a hand does: "ArrowLeft", "Tab", "+", "Shift+ArrowLeft"."""
        key = name.removeprefix("Shift+")
        event = {"key": key, "modifiers": 8 if key != name else 0}
        if key in KEYS:
            event |= {"windowsVirtualKeyCode": KEYS[key], "code": key}
        text = {"text": "\r" if key == "Enter" else key} if key == "Enter" or len(key) == 1 else {}
        for _ in range(times):
            self.call("Input.dispatchKeyEvent", type="keyDown", **event, **text)
            self.call("Input.dispatchKeyEvent", type="keyUp", **event)

    def type(self, text):
        self.call("Input.insertText", text=text)

    def mouse(self, kind, x, y, wheel=0):
        """Moves, presses or releases the left button, or turns the wheel, at a point of the window."""
        button = "left" if kind in ("mousePressed", "mouseReleased") else "none"
        scroll = {"deltaX": 0, "deltaY": wheel} if kind == "mouseWheel" else {}
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, clickCount=1, **scroll)

    def resize(self, width, height, phone=False):
        """A window, or a phone."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=2 if phone else 1, mobile=phone)

    def prefer(self, scheme):
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
