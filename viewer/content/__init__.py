"""What the page shows, as arrays and as answers to requests; nothing here knows of a server."""
