let install () =
  let arrived = ref false in
  let restore () =
    Sys.set_signal Sys.sigint Sys.Signal_default;
    Sys.set_signal Sys.sigterm Sys.Signal_default
  in
  let handle =
    Sys.Signal_handle
      (fun _ ->
         arrived := true;
         restore ())
  in
  Sys.set_signal Sys.sigint handle;
  Sys.set_signal Sys.sigterm handle;
  fun () -> !arrived
