type t = { seconds : float option; memory : int }

let seconds =
  Options.maybe Check_options.seconds_conv [ "seconds" ] ~docv:"S"
    "Gives up after $(docv) seconds of the clock. No default."

let term =
  let make seconds memory = { seconds; memory = Check_options.words_of memory } in
  Cmdliner.Term.(const make $ seconds $ Check_options.memory ())

let exit = "if it was interrupted, or met the limit of --seconds or --memory."

let stopped bounds (stop : Scc_graph_search.Limits.stop) =
  let why =
    match (stop, bounds.seconds) with
    | Interrupted, _ | Seconds, None -> "interrupted"
    | Seconds, Some s -> Printf.sprintf "the limit of %g seconds has passed" s
    | Memory, _ -> "the limit of memory was met"
  in
  why ^ ": nothing was written"

let within console bounds work report =
  let watch = Watch.start ?seconds:bounds.seconds ~memory:bounds.memory () in
  let done_ = (Watch.attempt watch).run Exploring work in
  Watch.finish watch;
  match done_ with
  | Error stop -> Ok (Guard.stopped console (stopped bounds stop))
  | Ok (Error _ as faults) -> faults
  | Ok (Ok found) ->
    Console.progress_done console;
    report found
