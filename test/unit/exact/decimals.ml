(* Answers decimals_test.py: of each line, as `significant 6 22/7`, the decimal. *)

open Scc_exact

let answer line =
  match String.split_on_char ' ' line with
  | [ what; digits; number ] -> (
      let x = Q.of_string number and digits = int_of_string digits in
      match what with
      | "fixed" -> Decimal.fixed ~places:digits x
      | "down" -> Decimal.rounded_down ~places:digits x
      | "up" -> Decimal.rounded_up ~places:digits x
      | "padded" -> Decimal.padded ~places:digits x
      | "significant" -> Decimal.significant ~digits x
      | "above" -> Decimal.significant_above ~digits x
      | "marked" -> Decimal.marked x
      | "exact" -> Option.value ~default:"none" (Decimal.exact x)
      | _ -> failwith line)
  | _ -> failwith line

let rec go () =
  match input_line stdin with
  | line ->
    print_endline (answer line);
    go ()
  | exception End_of_file -> ()

let () = go ()
