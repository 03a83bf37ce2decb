let seconds =
  Options.maybe Check_options.seconds_conv [ "seconds" ] ~docv:"S"
    "Gives up after $(docv) seconds of the clock. No default."

let stopped ~seconds (stop : Scc_graph_search.Limits.stop) =
  let why =
    match (stop, seconds) with
    | Interrupted, _ | Seconds, None -> "interrupted"
    | Seconds, Some s -> Printf.sprintf "the limit of %g seconds has passed" s
    | Memory, _ -> "the limit of memory was met"
  in
  why ^ ": nothing was written"

let within console ~seconds work report =
  let watch = Watch.start ?seconds () in
  let done_ = (Watch.attempt watch).run Exploring work in
  Watch.finish watch;
  match done_ with
  | Error stop -> Ok (Guard.stopped console (stopped ~seconds stop))
  | Ok (Error _ as faults) -> faults
  | Ok (Ok found) ->
    Console.progress_done console;
    report found
