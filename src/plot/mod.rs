//! Plots and pages, without a viewer.
