#!/usr/bin/env python3
"""Probes the WebGL 2 of headless Chromium (SwiftShader, no GPU, no network but this machine's own) with the probes of
`refraster gl --probe`, and compares what they find with the shipped profile `swiftshader`.

    probe_web.py PROGRAM        the program probe_web

Exit 1 where more was measured than the profile allows, or less than half of it. Exit 77, with a word, where there is no Chromium."""

import http.server
import json
import pathlib
import subprocess
import sys
import tempfile
import threading

import run as web


class Bridge:
    """Between the page, which posts answers, and the program, whose calls they are answers to."""

    def __init__(self, program):
        self.program, self.process, self.table, self.error = program, None, "", ""

    def start(self, driver):
        self.process = subprocess.Popen([self.program, "swiftshader", driver], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE)
        return self.calls()

    def answer(self, body):
        self.process.stdin.write(len(body).to_bytes(8, "little") + body)
        self.process.stdin.flush()
        return self.calls()

    def calls(self):
        """Up to one that is to be answered; none at the end."""
        lines = []
        for line in self.process.stdout:
            if line.startswith(b'["finish"'):
                self.table = json.loads(line)[1]
                return b""
            lines.append(line)
            if line.startswith(b'["?'):
                return b"".join(lines)
        return b""


def handler(bridge):
    class Handler(http.server.BaseHTTPRequestHandler):
        def reply(self, body, kind):
            self.send_response(200)
            self.send_header("Content-Type", kind)
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def do_GET(self):
            page = pathlib.Path(__file__).resolve().parent / "probe.html"
            self.reply(page.read_bytes() if self.path == "/" else b"", "text/html")

        def do_POST(self):
            body = self.rfile.read(int(self.headers.get("Content-Length") or 0))
            if self.path == "/error":
                bridge.error = body.decode()
            self.reply(bridge.start(body.decode()) if self.path == "/start"
                       else bridge.answer(body) if self.path == "/answer" else b"", "text/plain")

        def log_message(self, *_):
            pass

    return Handler


def main():
    browser = web.browser()
    if not browser:
        print("SKIPPED, not tested: no Chromium (Debian: apt-get install chromium)")
        return 77
    bridge = Bridge(pathlib.Path(sys.argv[1]).resolve())
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler(bridge))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory() as folder:
        _, messages = web.drawn(browser, f"http://127.0.0.1:{server.server_port}/", folder)
    server.shutdown()
    if not bridge.process:
        print(f"the page did not run: {bridge.error or messages[-2000:]}")
        return 1
    bridge.process.stdin.close()
    code = bridge.process.wait()
    print(bridge.table or f"the probes did not finish: {bridge.error or messages[-2000:]}", end="")
    return code


sys.exit(main())
