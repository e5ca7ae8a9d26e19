//! A drawing of as many pieces as are wanted.

/// Zigzags of some 1,100 pieces each in so many rows, and above them a line.
pub(crate) fn zigzags(rows: u32) -> String {
    let corner = |row: u32, i: u32| format!("L{} {}", 12 + 9 * i, 100 + 12 * row + 6 * (i % 2));
    let corners = |row: u32| (1..110).map(|i| corner(row, i)).collect::<String>();
    let row = |row: u32| format!("M12 {}{}", 100 + 12 * row, corners(row));
    let path = |path: &str| format!(r#"<path d="{path}" fill="none" stroke="black" stroke-width="1"/>"#);
    let rows: String = (0..rows).map(|i| path(&row(i))).collect();
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1024 768">{rows}{}</svg>"#,
        path("M300 40H500")
    )
}
