#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| polhode_fuzz::targets::foreign(polhode_fuzz::scratch(), bytes));
