#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| polhode_fuzz::targets::formula(polhode_fuzz::scratch(), bytes));
