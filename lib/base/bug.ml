exception Bug of (string * int * int * int) * string

let fail pos what = raise (Bug (pos, what))

let () =
  Printexc.register_printer (function
      | Bug ((file, line, _, _), what) ->
        Some (Printf.sprintf "Bug at %s:%d: %s" file line what)
      | _ -> None)
