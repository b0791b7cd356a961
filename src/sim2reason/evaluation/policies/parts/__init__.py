"""What policies share: secrets, requests over HTTP, answers of endpoints, waiting and budgets."""
