"""The command that shows bodies: in the browser, in a window, or as a page to mail."""
