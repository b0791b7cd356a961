"""Helpers for the tiny models of all servers."""

CONTEXT = 512
TEMPLATE = "{% for message in messages %}<{{ message['role'] }}>{{ message['content'] }}{% endfor %}<assistant>"
