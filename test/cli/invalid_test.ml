(* Every case of specs/conformance/invalid, and that every code has one. *)

let cases = Filename.concat ".." (Filename.concat ".." "specs/conformance/invalid")

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let files folder ending =
  Sys.readdir folder |> Array.to_list
  |> List.filter (fun f -> Filename.check_suffix f ending)
  |> List.sort String.compare

let is_case file = List.exists (Filename.check_suffix file) [ ".sc"; ".xml"; ".osc" ]

let inputs folder =
  Sys.readdir folder |> Array.to_list |> List.filter is_case |> List.sort String.compare

let run scc case =
  let output = Filename.temp_file "scc" ".out" in
  let words = [ "./run-case"; scc; Filename.concat cases case ] in
  let command = String.concat " " (List.map Filename.quote words) ^ " > " ^ Filename.quote output in
  let code = Sys.command command in
  let text = read output in
  Sys.remove output;
  Alcotest.(check int) "run-case itself" 0 code;
  text

let contains text piece =
  let n = String.length text and k = String.length piece in
  let rec from i = i + k <= n && (String.equal (String.sub text i k) piece || from (i + 1)) in
  from 0

let check scc case () =
  let expected = read (Filename.concat cases (Filename.remove_extension case ^ ".out")) in
  let found = run scc case in
  Alcotest.(check string) case expected found;
  let code = List.hd (String.split_on_char '-' case) in
  let is_named = contains found ("[" ^ code ^ "]") || contains found (Printf.sprintf "%S" code) in
  Alcotest.(check bool) ("names " ^ code) true is_named

(* A code is covered by a case named after it or by a cram test that shows it. *)
let covered crams code =
  List.exists (fun f -> contains f (code ^ "-")) (inputs cases)
  || List.exists (fun text -> contains text ("[" ^ code ^ "]")) crams

let every_code () =
  let crams = List.map read (files "." ".t") in
  let codes = List.map (fun (code, _) -> (code : Scc_base.Code.t :> string)) Scc_base.Code.all in
  let missing = List.filter (fun code -> not (covered crams code)) codes in
  Alcotest.(check (list string)) "codes without a case" [] missing

let () =
  let scc = Filename.concat (Sys.getcwd ()) Sys.argv.(1) in
  let one case = Alcotest.test_case case `Quick (check scc case) in
  Alcotest.run ~argv:[| Sys.argv.(0) |] "invalid inputs"
    [
      ("cases", List.map one (inputs cases));
      ("codes", [ Alcotest.test_case "every code has a case" `Quick every_code ]);
    ]
