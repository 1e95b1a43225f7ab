/// Runs a computation compiled for the widest vector registers that this processor has.
///
/// The compiler vectorises what is inlined into `computation`; mark the closure and what it calls `#[inline(always)]`.
/// No operation is fused or reordered, so the bits are the same on every processor: only the time differs.
///
/// ```
/// # use polhode::numerics::vectorised;
/// let doubled = vectorised(#[inline(always)] || [1.0, 2.0, 3.0, 4.0].map(|x| 2.0 * x));
/// assert_eq!(doubled, [2.0, 4.0, 6.0, 8.0]);
/// ```
#[inline]
pub fn vectorised<T>(computation: impl FnOnce() -> T) -> T {
    pulp::Arch::new().dispatch(computation)
}
