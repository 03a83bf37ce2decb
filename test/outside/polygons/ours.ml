(* The same input as convex.cpp, and the same output, by lib/polygon. *)

open Scc_exact
open Scc_polygon

let numbers line = List.map int_of_string (List.filter (fun w -> w <> "") (String.split_on_char ' ' line))

let rec points = function
  | x :: y :: rest -> { Grid.x = Rat.of_int x; y = Rat.of_int y } :: points rest
  | _ -> []

let () =
  try
    while true do
      match numbers (input_line stdin) with
      | [] -> ()
      | n :: rest -> (
          match Polygon.make (Array.of_list (points rest)) [ Array.init n Fun.id ] with
          | Ok polygon -> Printf.printf "%d\n" (List.length (Partition.convex polygon))
          | Error _ -> print_endline "refused")
    done
  with End_of_file -> ()
