#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Drops a file on an X window, as a file manager does: drop_file.py WINDOW FILE. Protocol: XDND, version 5."""
import ctypes
import sys
import time

CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
x = ctypes.CDLL("libX11.so.6")
x.XOpenDisplay.restype = ctypes.c_void_p
for function in ("XInternAtom", "XDefaultRootWindow", "XCreateSimpleWindow"):
    getattr(x, function).restype = ctypes.c_ulong


class ClientMessage(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("message_type", ctypes.c_ulong),
                ("format", ctypes.c_int), ("data", ctypes.c_long * 5)]


class Selection(ctypes.Structure):  # a request has the owner before the requestor
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("values", ctypes.c_ulong * 6)]


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("message", ClientMessage), ("selection", Selection),
                ("pad", ctypes.c_long * 24)]


target, path = int(sys.argv[1]), sys.argv[2]
display = ctypes.c_void_p(x.XOpenDisplay(None))
window = ctypes.c_ulong
root = x.XDefaultRootWindow(display)
source = x.XCreateSimpleWindow(display, window(root), 0, 0, 1, 1, 0, window(0), window(0))


def atom(name):
    return x.XInternAtom(display, name.encode(), 0)


def send(name, *values):
    event = Event()
    event.message.type, event.message.window, event.message.format = CLIENT_MESSAGE, target, 32
    event.message.message_type = atom(name)
    for i, value in enumerate((source,) + values):
        event.message.data[i] = value
    x.XSendEvent(display, window(target), 0, ctypes.c_long(0), ctypes.byref(event))
    x.XFlush(display)


x.XSetSelectionOwner(display, window(atom("XdndSelection")), window(source), window(0))
send("XdndEnter", 5 << 24, atom("text/uri-list"))
send("XdndPosition", 0, (600 << 16) | 300, 0, atom("XdndActionCopy"))
send("XdndDrop", 0, 0)
event, end = Event(), time.time() + 10
while time.time() < end:
    if x.XPending(display) == 0:
        time.sleep(0.02)
        continue
    x.XNextEvent(display, ctypes.byref(event))
    if event.type == CLIENT_MESSAGE and event.message.message_type == atom("XdndFinished"):
        sys.exit(0)
    if event.type != SELECTION_REQUEST:
        continue
    _owner, requestor, selection, kind, place, when = event.selection.values
    text = ("file://" + path + "\r\n").encode()
    x.XChangeProperty(display, window(requestor), window(place), window(kind), 8, 0, text, len(text))
    answer = Event()
    answer.selection.type = SELECTION_NOTIFY
    for i, value in enumerate((requestor, selection, kind, place, when)):
        answer.selection.values[i] = value
    x.XSendEvent(display, window(requestor), 0, ctypes.c_long(0), ctypes.byref(answer))
    x.XFlush(display)
sys.exit("the window did not take the file")
