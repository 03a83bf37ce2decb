let mib = 1024 * 1024
let word = Sys.word_size / 8
let words_of_bytes n = n / word
let words_of_mib n = words_of_bytes (n * mib)
let bytes_of_words n = n * word
let heap_words () = (Gc.quick_stat ()).heap_words

let spare_tables () = Gc.set { (Gc.get ()) with custom_major_ratio = 1000; space_overhead = 200 }
let spare_runs () = Gc.set { (Gc.get ()) with space_overhead = 400 }

let beside_bytes = ref 0
let beside () = !beside_bytes
let set_beside bytes = beside_bytes := bytes
