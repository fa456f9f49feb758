#!/usr/bin/env python3
"""Serves a folder to browsers on this machine, and allows its pages memory that threads share, which pages from a folder don't get:

    examples/live/serve.py build/live

Another server has to send the two headers for all files of the page.
"""
import argparse
import functools
import http.server


class Handler(http.server.SimpleHTTPRequestHandler):
    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, ".wasm": "application/wasm", ".js": "text/javascript"}

    def end_headers(self):
        self.send_header("Cross-Origin-Opener-Policy", "same-origin")
        self.send_header("Cross-Origin-Embedder-Policy", "require-corp")
        super().end_headers()

    def log_request(self, *_):
        pass # errors alone are worth a line


def main():
    parser = argparse.ArgumentParser(description="Serves quell's live page, so that it runs on several threads.")
    parser.add_argument("folder", help="the page's, or one that has it in it")
    parser.add_argument("--port", type=int, default=8000, help="0: any that is free")
    given = parser.parse_args()
    with http.server.ThreadingHTTPServer(("127.0.0.1", given.port), functools.partial(Handler, directory=given.folder)) as server:
        print(f"http://127.0.0.1:{server.server_port}/", flush=True)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            pass


if __name__ == "__main__":
    main()
