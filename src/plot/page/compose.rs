use super::base64::base64;
use super::{sections, strobe};
use crate::plot::svg::escaped;
use crate::plot::{Motion, font, plain_time};
use crate::recording::{Heading, Sampling};
use crate::scenario::Plan;

/// What a page is made of.
#[derive(Debug)]
pub struct Page<'a> {
    /// One line: what this is.
    pub title: &'a str,
    /// The file or the scene that was asked for.
    pub source: &'a str,
    /// Bodies, provenance, certificates.
    pub heading: &'a Heading,
    /// How many samples, and when.
    pub sampling: Sampling,
    /// The plan with what its checks have found, if the scene is known.
    pub plan: Option<&'a Plan>,
    /// All samples.
    pub motion: &'a Motion,
    /// What is not in it, and why not.
    pub remarks: &'a [String],
    /// Lines for a shell that make the recording and the page again.
    pub commands: &'a [String],
}

/// Of a chart on a page, pixels: narrow, so that its words can be read on a telephone.
const CHART: (f64, f64) = (500.0, 240.0);

impl Page<'_> {
    /// The page. It has everything in it: no script, no image or style from elsewhere.
    #[must_use]
    pub fn html(&self) -> String {
        let head = self.head();
        let body = [
            self.lead(),
            sections::verdicts(self),
            strobe::section(self),
            self.plots(),
            sections::making(self),
            sections::provenance(self),
            sections::reproduction(self),
        ];
        format!("<!DOCTYPE html>\n<html lang=\"en\">\n{head}<body>\n{}</body>\n</html>\n", body.concat())
    }

    fn head(&self) -> String {
        // The letters of the plots, for a browser that has no such font.
        let font = base64(font::FILE);
        format!(
            "<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"generator\" content=\"polhode {}\">\n<title>{}</title>\n<style>\n{}@font-face {{ font-family: \
             \"DejaVu Sans\"; src: url(data:font/ttf;base64,{font}) format(\"truetype\"); }}\n</style>\n</head>\n",
            env!("CARGO_PKG_VERSION"),
            escaped(self.title),
            include_str!("style.css"),
        )
    }

    fn lead(&self) -> String {
        let Sampling { samples, from_s, to_s, .. } = self.sampling;
        let times = format!("{} to {} s", plain_time(from_s), plain_time(to_s));
        let source = escaped(self.source);
        let mut text = format!(
            "<header>\n<h1>{}</h1>\n<p class=\"faint\"><code>{source}</code>: {} samples, {times}</p>\n",
            escaped(self.title),
            crate::plot::grouped(samples),
        );
        let summary = self.plan.map(|plan| plan.summary.as_str()).unwrap_or_default();
        for paragraph in summary.split("\n\n").map(str::trim).filter(|paragraph| !paragraph.is_empty()) {
            text.extend([format!("<p>{}</p>\n", escaped(paragraph))]);
        }
        for remark in self.remarks {
            text.extend([format!("<p class=\"faint\">Not in this page: {}</p>\n", escaped(remark))]);
        }
        text + "</header>\n"
    }

    fn plots(&self) -> String {
        let bodies = self.motion.panels(CHART);
        let is_one = bodies.len() == 1;
        let mut text = "<section>\n<h2>The motion against time</h2>\n".to_owned();
        for (name, panels) in bodies {
            if !is_one {
                text.extend([format!("<h3>{}</h3>\n", escaped(name))]);
            }
            text += "<div class=\"figures\">\n";
            for panel in panels {
                text += &sections::figure(&panel, None);
            }
            text += "</div>\n";
        }
        text + "</section>\n"
    }
}
