//! Addresses that a browser follows.

use raybook_chapters::kit::address::{self, encoded};

#[test]
fn what_means_something_in_an_address_is_encoded() {
    assert_eq!(encoded("a-b_c.d"), "a-b_c.d");
    assert_eq!(
        encoded("1 000/? #%&\"ä"),
        "1%20000%2F%3F%20%23%25%26%22%C3%A4"
    );
}

#[cfg(unix)]
#[test]
fn the_address_of_a_file_keeps_its_slashes() {
    let path = std::path::Path::new("/a b/my#rays/100%/x.html");
    assert_eq!(
        address::of_file(path),
        "file:///a%20b/my%23rays/100%25/x.html"
    );
}
