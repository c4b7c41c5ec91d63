"""Formats that other libraries read, each file in a process of its own."""
