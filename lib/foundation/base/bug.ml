exception Bug of (string * int * int * int) * string

let fail pos what = raise (Bug (pos, what))

let broken = function
  | ( Bug _ | Invalid_argument _ | Failure _ | Not_found | Division_by_zero | Match_failure _ | Assert_failure _
    | Stack_overflow ) as e ->
    Some (Printexc.to_string e)
  | _ -> None

let () =
  Printexc.register_printer (function
      | Bug ((file, line, _, _), what) ->
        Some (Printf.sprintf "Bug at %s:%d: %s" file line what)
      | _ -> None)
