external trim : unit -> unit = "scc_trim" [@@noalloc]

let compact () =
  Gc.compact ();
  trim ()
