"""The server of the page: requests in, answers of a worker process out."""
