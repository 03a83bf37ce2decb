let mib = 1024 * 1024
let word = Sys.word_size / 8
let words_of_bytes n = n / word
let words_of_mib n = words_of_bytes (n * mib)
let bytes_of_words n = n * word
let heap_words () = (Gc.quick_stat ()).heap_words
