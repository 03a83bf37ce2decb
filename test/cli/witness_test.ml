(* Every witness of every model, replayed by the program itself: it leads to the state that it names. *)

let models = "../../specs/models"
let scc = Filename.concat (Sys.getcwd ()) Sys.argv.(1)

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let run words ~into =
  Sys.command (String.concat " " (List.map Filename.quote (scc :: words)) ^ " > " ^ Filename.quote into)

let member key json = Yojson.Basic.Util.member key json
let text json = Yojson.Basic.to_string json

let lines trace =
  List.filter (fun l -> String.length l > 0) (String.split_on_char '\n' (read trace))
  |> List.map (fun l -> Yojson.Basic.from_string l)

let last list = List.nth list (List.length list - 1)

let last_state trace =
  let state line = match member "state" line with `Null -> None | s -> Some s in
  match List.filter_map state (lines trace) with
  | [] -> Alcotest.fail "a trace without a state"
  | states -> last states

(* A run that ends in a dead end is told, and the model given up there. *)
let exit_code trace =
  match member "ending" (last (lines trace)) with
  | `String "stuck" -> 2
  | `String ("open" | "quiescent") -> 0
  | _ -> Alcotest.fail "a trace without its end"

let replay folder model property =
  match member "witness" property with
  | `Null -> 0
  | witness ->
    let name = Yojson.Basic.Util.to_string (member "name" property) in
    let schedule = Filename.concat folder (name ^ ".json") in
    let trace = Filename.concat folder "trace.jsonl" in
    let code = run [ "trace"; model; "--schedule"; schedule ] ~into:trace in
    Alcotest.(check int) (name ^ ": exit code") (exit_code trace) code;
    Alcotest.(check string) (name ^ ": final state") (text (member "state" witness)) (text (last_state trace));
    let explanation = Filename.concat folder "explanation.txt" in
    Alcotest.(check int) (name ^ ": explained") 0 (run [ "explain"; schedule; model ] ~into:explanation);
    1

let check model () =
  let folder = Filename.temp_file "scc" "" in
  Sys.remove folder;
  let report = Filename.temp_file "scc" ".json" in
  let code = run [ "check"; model; "--json"; "--witness"; folder ] ~into:report in
  Alcotest.(check bool) "a verdict" true (code <= 2);
  let document = Yojson.Basic.from_string (read report) in
  let properties = Yojson.Basic.Util.to_list (member "properties" document) in
  let replayed = List.fold_left (fun n p -> n + replay folder model p) 0 properties in
  let schedules =
    Array.to_list (Sys.readdir folder) |> List.filter (fun f -> Filename.check_suffix f ".json")
  in
  Alcotest.(check bool) "witnesses of undecided properties are schedules too" true
    (List.length schedules >= replayed);
  Array.iter (fun f -> Sys.remove (Filename.concat folder f)) (Sys.readdir folder);
  Sys.rmdir folder;
  Sys.remove report

let () =
  let files =
    Array.to_list (Sys.readdir models)
    |> List.filter (fun f -> Filename.check_suffix f ".sc")
    |> List.sort String.compare
  in
  let case f = Alcotest.test_case f `Quick (check (Filename.concat models f)) in
  Alcotest.run ~argv:[| Sys.argv.(0) |] "witnesses" [ ("replayed", List.map case files) ]
