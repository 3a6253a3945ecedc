"""The path of a page, its file and its address."""

import pytest

from sitegen import pagepath


@pytest.mark.parametrize(
    ("path", "file"), [("", "index.html"), ("a/b/", "a/b/index.html"), ("404.html", "404.html")]
)
def test_a_path_and_its_file_lead_to_each_other(path: str, file: str) -> None:
    assert pagepath.file_of(path) == file
    assert pagepath.path_of(file) == path


def test_only_index_html_is_served_as_a_folder() -> None:
    assert pagepath.path_of("a/index.html.map") == "a/index.html.map"
    assert pagepath.path_of("a/my-index.html") == "a/my-index.html"


@pytest.mark.parametrize("text", ["demo", "/demo", "demo/", "/demo/"])
def test_authors_may_leave_out_the_slashes(text: str) -> None:
    assert pagepath.normalized(text) == "demo/"


def test_the_first_page_has_an_empty_path() -> None:
    assert pagepath.normalized("/") == ""
