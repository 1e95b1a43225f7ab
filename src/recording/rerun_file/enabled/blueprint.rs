use std::io::Write;

use re_chunk::{EntityPath, TimeColumn, Timeline};
use re_log_types::TimeType;
use re_sdk_types::AsComponents;
use re_sdk_types::blueprint::archetypes::{
    ContainerBlueprint, PanelBlueprint, TimePanelBlueprint, ViewBlueprint, ViewContents, ViewportBlueprint,
};
use re_sdk_types::blueprint::components::{
    ContainerKind, IncludedContent, LoopMode, PanelState, PlayState, QueryExpression, RootContainer, ViewClass,
};
use uuid::Uuid;

use super::columns::SIM_TIME;
use super::identity;
use super::stream::{Store, Stream};
use crate::recording::RecordingError;

/// Writes the parts of a layout, each under its own counted id.
///
/// The archetypes are written one by one, as the viewer stores them: a layout made by the SDK has random ids, and
/// neither camera nor axes.
pub(super) struct Blueprint<'a, W> {
    stream: &'a mut Stream<W>,
    store: Store,
    times: [TimeColumn; 1],
    parts: u64,
}

/// A view or a container: something that a container holds.
#[derive(Debug, Clone)]
pub(super) struct Part {
    id: Uuid,
    path: String,
}

/// What a view is of.
pub(super) struct View<'a> {
    /// `3D`, `TimeSeries`, `TextDocument`, `TextLog`.
    pub(super) class: &'static str,
    pub(super) name: &'a str,
    pub(super) origin: &'a str,
    /// Entities, as queries: `/body/a/plots/energy`, `$origin/**`, `- /world/axes/**` for what is left out.
    pub(super) contents: &'a [String],
}

/// How a container lays out what it holds.
pub(super) struct Container<'a> {
    pub(super) kind: ContainerKind,
    pub(super) name: &'a str,
    pub(super) parts: &'a [Part],
    /// Shares of the width (of the height in a vertical one); empty: equal.
    pub(super) shares: &'a [f32],
}

impl Part {
    /// Where a property of a view is stored.
    pub(super) fn property(&self, name: &str) -> String {
        format!("{}/{name}", self.path)
    }

    /// Where a view stores what it does otherwise with one entity.
    pub(super) fn overridden(&self, entity: &str) -> String {
        ViewContents::blueprint_base_visualizer_path_for_entity(self.id, &EntityPath::from(entity)).to_string()
    }
}

impl<'a, W: Write> Blueprint<'a, W> {
    pub(super) fn new(stream: &'a mut Stream<W>, store: Store) -> Self {
        let timeline = Timeline::new("blueprint", TimeType::Sequence);
        Self { stream, store, times: [TimeColumn::new(Some(true), timeline, vec![0].into())], parts: 0 }
    }

    /// Logs one archetype of the layout.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn set(&mut self, path: &str, archetype: &dyn AsComponents) -> Result<(), RecordingError> {
        self.stream.once(self.store, path, &self.times, archetype)
    }

    /// Adds a view.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn view(&mut self, view: &View<'_>) -> Result<Part, RecordingError> {
        let part = self.part("view");
        let queries = view.contents.iter().map(|query| {
            QueryExpression::from(if query.starts_with('-') { query.clone() } else { format!("+ {query}") })
        });
        self.set(&part.property("ViewContents"), &ViewContents::new(queries))?;
        let archetype =
            ViewBlueprint::new(ViewClass::from(view.class)).with_display_name(view.name).with_space_origin(view.origin);
        self.set(&part.path, &archetype)?;
        Ok(part)
    }

    /// Adds a container; of a container of tabs the first is shown.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn container(&mut self, container: &Container<'_>) -> Result<Part, RecordingError> {
        let part = self.part("container");
        let contents = container.parts.iter().map(|part| IncludedContent::from(part.path.as_str()));
        let mut archetype = ContainerBlueprint::new(container.kind).with_contents(contents);
        if !container.name.is_empty() {
            archetype = archetype.with_display_name(container.name);
        }
        let shares = container.shares.iter().copied();
        archetype = match container.kind {
            ContainerKind::Vertical => archetype.with_row_shares(shares),
            ContainerKind::Horizontal => archetype.with_col_shares(shares),
            ContainerKind::Tabs | ContainerKind::Grid => archetype,
        };
        if let (ContainerKind::Tabs, Some(first)) = (container.kind, container.parts.first()) {
            archetype = archetype.with_active_tab(first.path.as_str());
        }
        self.set(&part.path, &archetype)?;
        Ok(part)
    }

    /// Makes `root` the whole, with the panels about it: time below, playing at `speed` seconds a second; no others.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn root(&mut self, root: &Part, speed: f64) -> Result<(), RecordingError> {
        let viewport = ViewportBlueprint::new()
            .with_root_container(RootContainer::from(re_sdk_types::datatypes::Uuid::from(root.id)))
            .with_auto_layout(false)
            .with_auto_views(false);
        self.set("viewport", &viewport)?;
        let time = TimePanelBlueprint::new()
            .with_state(PanelState::Collapsed)
            .with_timeline(SIM_TIME)
            .with_play_state(PlayState::Playing)
            .with_loop_mode(LoopMode::All)
            .with_playback_speed(speed);
        self.set("time_panel", &time)?;
        for panel in ["selection_panel", "blueprint_panel"] {
            self.set(panel, &PanelBlueprint::new().with_state(PanelState::Collapsed))?;
        }
        Ok(())
    }

    fn part(&mut self, kind: &str) -> Part {
        self.parts += 1;
        let id = identity::part(self.parts);
        Part { id, path: format!("{kind}/{id}") }
    }
}
