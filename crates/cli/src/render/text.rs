//! Text from outside, a blade's name say: made harmless, and broken into lines.

use unicode_width::UnicodeWidthStr;

/// `text` with what would move a terminal's cursor or turn round the order of the letters written
/// out, as faults have it: `\u{1b}`, `\n`.
pub(crate) fn visible(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        if is_control(letter) { out.extend(letter.escape_default()) } else { out.push(letter) }
    }
    out
}

/// Control characters, separators of lines, and what turns round the direction of writing.
fn is_control(letter: char) -> bool {
    letter.is_control() || matches!(letter, '\u{2028}'..='\u{202E}' | '\u{2066}'..='\u{2069}')
}

/// `text` in lines of at most `width` columns, broken between words, each but the first indented.
pub(crate) fn wrap(text: &str, indent: usize, width: usize) -> String {
    let mut out = String::new();
    let mut column = indent;
    for word in text.split_whitespace() {
        let word = visible(word);
        if column > indent && column + 1 + word.width() > width {
            out.push('\n');
            out.push_str(&spaces(indent));
            column = indent;
        } else if column > indent {
            out.push(' ');
            column += 1;
        }
        column += word.width();
        out.push_str(&word);
    }
    out
}

/// So many blanks.
pub(crate) fn spaces(count: usize) -> String {
    " ".repeat(count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_controls_a_terminal_is_written_out() {
        let cases = [
            ("a\u{1b}[2Jb", r"a\u{1b}[2Jb"),
            ("a\u{1b}]0;title\u{7}b", r"a\u{1b}]0;title\u{7}b"),
            ("\u{7f}\u{9b}", r"\u{7f}\u{9b}"),
            ("a\r\n\tb", r"a\r\n\tb"),
            ("a\u{202e}b\u{2069}\u{2028}", r"a\u{202e}b\u{2069}\u{2028}"),
            (r"C:\blades\ü×Ω旋翼.toml", r"C:\blades\ü×Ω旋翼.toml"),
        ];
        for (text, shown) in cases {
            assert_eq!(visible(text), shown);
        }
    }

    #[test]
    fn text_wraps_between_words() {
        assert_eq!(wrap("one two three", 2, 9), "one two\n  three");
        assert_eq!(wrap("one\u{1b}two three", 0, 13), "one\\u{1b}two\nthree", "as wide as it is shown");
        assert_eq!(wrap("旋翼 旋翼", 0, 8), "旋翼\n旋翼", "letters of two columns");
        assert_eq!(wrap("endless", 0, 3), "endless", "a word is not broken");
    }
}
