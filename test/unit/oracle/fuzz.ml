(* Malformed and hostile messages for the oracle, mixed with questions whose answers are known:

   fuzz COUNT [SEED]

   Each message is a line. A line that is a request in JSON, whatever is wrong with it, has exactly one answer,
   with its id; any other line has one answer, or none; known questions have always the same answer, byte for byte;
   no answer is an internal error; and the heap is no larger at the end than it was after the first fifth. Says
   what was seen; exit code 1 for a fault. *)

open Scc_oracle
open Oracle_cases
module Random = Scc_runs.Splitmix64

(* {1 Chance} *)

let generator = ref (Random.of_seed 1L)

let below n =
  let k, g = Random.below n !generator in
  generator := g;
  k

let pick list = List.nth list (below (List.length list))
let one_in n = below n = 0

(* {1 Faults} *)

let faults = ref 0

let shorten s = if String.length s <= 300 then s else String.sub s 0 300 ^ " ..."

let fault line fmt =
  Printf.ksprintf
    (fun why ->
       incr faults;
       if !faults <= 20 then Printf.printf "FAULT: %s\n  line: %s\n%!" why (String.escaped (shorten line)))
    fmt

(* {1 Messages} *)

let odd_numbers =
  [
    "0"; "-0"; "-1"; "1e3"; "1e999"; "1e-999"; "1e9999"; "1e999999999"; "0.1"; "-1.5e-7"; "1.0";
    "9007199254740993";
    "123456789012345678901234567890"; "4294967296"; "-9223372036854775808"; "2";
  ]

let odd_texts =
  [
    ""; "1/2"; "-7/3"; "1/0"; "0/5"; "1e999999"; "NaN"; "inf"; "-"; "/"; "1/"; "s1"; "s2"; "s3"; "s99999"; "m1";
    "m2";
    "here"; "all"; "first"; "2.0"; "\xff"; "\xc3\xa9"; "\x00"; "possibly"; "true"; "bonds(k)";
    "x(p) / (x(p) - x(p))";
    "always possibly bonds(k) = 0"; "time(3/2)"; "jsonrpc"; "model x"; String.make 3000 '9'; String.make 5000 '(';
  ]

(* Numbers are written as they are: [Yojson] would not. *)
type tree = Number of string | Text of string | Word of string | List of tree list | Object of (string * tree) list

let rec tree : Cases.json -> tree = function
  | `Null -> Word "null"
  | `Bool b -> Word (string_of_bool b)
  | `Int n -> Number (string_of_int n)
  | `Float x -> Number (Printf.sprintf "%.17g" x)
  | `String s -> Text s
  | `List l -> List (List.map tree l)
  | `Assoc members -> Object (List.map (fun (name, v) -> (name, tree v)) members)

let rec write b = function
  | Number s | Word s -> Buffer.add_string b s
  | Text s -> Buffer.add_string b (Yojson.Basic.to_string (`String s))
  | List items ->
    Buffer.add_char b '[';
    separate b (write b) items;
    Buffer.add_char b ']'
  | Object members ->
    Buffer.add_char b '{';
    separate b
      (fun (name, v) ->
         write b (Text name);
         Buffer.add_char b ':';
         write b v)
      members;
    Buffer.add_char b '}'

and separate : type a. Buffer.t -> (a -> unit) -> a list -> unit =
  fun b f items ->
  List.iteri
    (fun i x ->
       if i > 0 then Buffer.add_char b ',';
       f x)
    items

let written t =
  let b = Buffer.create 256 in
  write b t;
  Buffer.contents b

let rec any depth =
  match below (if depth > 3 then 4 else 6) with
  | 0 | 1 -> Number (pick odd_numbers)
  | 2 -> Text (pick odd_texts)
  | 3 -> Word (pick [ "null"; "true"; "false" ])
  | 4 -> List (List.init (below 5) (fun _ -> any (depth + 1)))
  | _ -> Object (List.init (below 4) (fun i -> (pick odd_texts ^ string_of_int i, any (depth + 1))))

let replace_nth n f list = List.mapi (fun i x -> if i = n then f x else x) list
let without_nth n list = List.filteri (fun i _ -> i <> n) list

(* Somewhere in a tree, something else. *)
let rec spoil t =
  match t with
  | List (_ :: _ as items) when not (one_in 5) -> (
      let n = below (List.length items) in
      match below 8 with
      | 0 -> List (without_nth n items)
      | 1 -> List (List.nth items n :: items)
      | _ -> List (replace_nth n spoil items))
  | Object (_ :: _ as members) when not (one_in 6) -> (
      let n = below (List.length members) in
      match below 12 with
      | 0 -> Object (without_nth n members)
      | 1 -> Object (replace_nth n (fun (_, v) -> (pick odd_texts, v)) members)
      | 2 -> Object (("limits", any 2) :: members)
      | _ -> Object (replace_nth n (fun (name, v) -> (name, spoil v)) members))
  | Number s when one_in 3 -> Number (s ^ pick [ "0"; "1"; "00"; ".5"; "e2" ])
  | Text s when one_in 3 && String.length s > 0 ->
    let i = below (String.length s) in
    Text (String.mapi (fun j c -> if i = j then Char.chr (below 128) else c) s)
  | _ -> any 0

let twisted line =
  let b = Bytes.of_string line in
  let n = Bytes.length b in
  if n = 0 then line
  else
    match below 5 with
    | 0 -> String.sub line 0 (below n)
    | 1 ->
      for _ = 0 to below 4 do Bytes.set b (below n) (Char.chr (below 256)) done;
      Bytes.to_string b
    | 2 ->
      let i = below n in
      let odd = pick [ "["; "{"; "\""; "\\"; "}"; "]"; ","; "\\ud800"; "//"; "NaN" ] in
      String.sub line 0 i ^ odd ^ String.sub line i (n - i)
    | 3 ->
      let i = below n in
      String.sub line 0 i ^ String.sub line i (n - i) ^ String.sub line i (n - i)
    | _ -> line ^ line

let noise () =
  match below 6 with
  | 0 -> String.init (below 200) (fun _ -> Char.chr (below 256))
  | 1 -> String.make (below 3000) '['
  | 2 -> String.concat "" (List.init (below 500) (fun _ -> "{\"a\":"))
  | 3 -> written (any 0)
  | 4 -> "[" ^ String.concat "," (List.init (below 300) (fun _ -> "1")) ^ "]"
  | _ -> pick [ "null"; ""; " "; "\xef\xbb\xbf{}"; "\""; "-"; "[[]]"; "[{}]"; {|{"jsonrpc":"2.0","method":"x"}|} ]

(* {1 Answers} *)

(* All but that of an internal error. *)
let codes = [ -32700; -32600; -32601; -32602 ] @ List.init 9 (fun i -> -32000 - i)
let seen : (int, int) Hashtbl.t = Hashtbl.create 16

let see code = Hashtbl.replace seen code (1 + Option.value (Hashtbl.find_opt seen code) ~default:0)

let names = function `Assoc members -> List.map fst members | _ -> []

(* The id of a proper response. *)
let id_of line (response : Cases.json) =
  let open Yojson.Basic.Util in
  (match names response with
   | [ "jsonrpc"; "id"; "result" ] ->
     see 0;
     (match member "result" response with `Assoc _ -> () | _ -> fault line "a result is no object")
   | [ "jsonrpc"; "id"; "error" ] ->
     let error = member "error" response in
     if names error <> [ "code"; "message"; "data" ] then fault line "a strange error";
     let code = to_int (member "code" error) in
     see code;
     if not (List.mem code codes) then
       fault line "error %d: %s" code (Yojson.Basic.to_string error)
   | _ -> fault line "no response: %s" (shorten (Yojson.Basic.to_string response)));
  member "id" response

let parsed line answer =
  match Yojson.Basic.from_string answer with
  | json -> Some json
  | exception Yojson.Json_error why ->
    fault line "an answer that is not JSON (%s): %s" why (shorten answer);
    None

let ask session line =
  match Oracle.handle session line with
  | answer -> answer
  | exception e ->
    fault line "exception %s" (Printexc.to_string e);
    None

(* A line of which nothing is known. *)
let whatever session line =
  match Option.bind (ask session line) (parsed line) with
  | None -> ()
  | Some (`List []) -> fault line "an empty batch of answers"
  | Some (`List responses) -> List.iter (fun r -> ignore (id_of line r)) responses
  | Some response -> ignore (id_of line response)

let id = ref 1000

let fresh () =
  incr id;
  !id

let load members = ("model.load", `Assoc members)

let cases =
  load [ ("text", `String Cases.model) ]
  :: load [ ("text", `String Cases.ranged); ("start", `Assoc [ ("random", `Int 7) ]) ]
  :: ("shape.define", Cases.cube) :: Cases.valid

let spoilt_request () =
  let name, params = pick cases in
  let name = if one_in 30 then pick odd_texts else name in
  let params = spoil (tree params) in
  let params = if one_in 4 then spoil params else params in
  let params =
    match params with
    | Object _ -> params
    | other -> if one_in 2 then other else Object [ ("a", other) ]
  in
  let id = fresh () in
  let head = [ ("jsonrpc", Text "2.0"); ("id", Number (string_of_int id)); ("method", Text name) ] in
  (id, Object (head @ [ ("params", params) ]))

let one_answer session (id, t) =
  let line = written t in
  match Option.bind (ask session line) (parsed line) with
  | None -> fault line "no answer"
  | Some response -> (
      match id_of line response with
      | `Int n when n = id -> ()
      | `Null -> ()  (* what is not JSON, such as a member that is given twice, has no id *)
      | _ -> fault line "the answer to another request")

let batch session =
  let requests = List.init (1 + below 6) (fun _ -> spoilt_request ()) in
  let line = written (List (List.map snd requests)) in
  match Option.bind (ask session line) (parsed line) with
  | Some (`List responses) ->
    let ids = List.map (id_of line) responses in
    if ids <> List.map (fun (id, _) -> `Int id) requests then fault line "answers are missing or out of order"
  | Some response -> ( match id_of line response with `Null -> () | _ -> fault line "a batch has one answer")
  | None -> fault line "no answer to a batch"

(* {1 Questions whose answers are known} *)

let question (name, params) = Yojson.Basic.to_string (Cases.request ~id:7 name params)

let stays (name, _) = not (String.equal name "shape.define")
let questions = List.map question (List.filter stays Cases.valid)

let set_up session =
  List.iter
    (fun request ->
       let line = Yojson.Basic.to_string request in
       match Option.bind (ask session line) (parsed line) with
       | Some response when List.mem "result" (names response) -> ()
       | _ -> fault line "the set-up is refused")
    Cases.setup

let known session expected =
  let line, answer = pick expected in
  match ask session line with
  | Some again when String.equal again answer -> ()
  | Some again -> fault line "another answer than before: %s\n  instead of %s" (shorten again) (shorten answer)
  | None -> fault line "no answer to what is known"

let answered session line =
  let answer = Option.value (ask session line) ~default:"null" in
  match parsed line answer with
  | Some response when List.mem "result" (names response) -> Some (line, answer)
  | Some _ | None ->
    fault line "no result: %s" (shorten answer);
    None

(* {1 Time and memory} *)

exception Late

(* Some spoilt requests ask for a lot: they are given up, as the program does. *)
let surroundings =
  let ring _ = raise Late in
  let timer seconds = ignore (Unix.setitimer ITIMER_REAL { it_interval = 0.; it_value = seconds }) in
  let bounded ~seconds:_ f =
    timer 0.5;
    match
      let x = f () in
      timer 0.;
      x
    with
    | x -> Ok x
    | exception Late -> Error Fault.Seconds
    | exception e ->
      timer 0.;
      raise e
  in
  Sys.set_signal Sys.sigalrm (Sys.Signal_handle ring);
  { Session.quiet with bounded }

(* Words that live, and of all of the heap. *)
let heap () =
  Gc.compact ();
  let s = Gc.stat () in
  (s.live_words, s.heap_words)

(* Handles are few, so that they are all taken soon. The first ones are released by no spoilt request. *)
let quotas = { Quotas.default with shapes = 64; models = 8; steps = 2000; states = 2000; reply_bytes = 1 lsl 20 }

let step session expected =
  match below 20 with
  | 0 | 1 | 2 | 3 -> known session expected
  | 4 | 5 -> whatever session (noise ())
  | 6 | 7 | 8 -> whatever session (twisted (written (snd (spoilt_request ()))))
  | 9 -> whatever session (twisted (pick questions))
  | 10 -> batch session
  | _ -> one_answer session (spoilt_request ())

let run count seed =
  generator := Random.of_seed seed;
  let session = Session.create ~quotas ~surroundings ~version:"fuzz" () in
  set_up session;
  let expected = List.filter_map (answered session) questions in
  let first = Int.max 1000 (count / 5) in
  for _ = 1 to Int.min first count do step session expected done;
  let live, _ = heap () in
  for _ = first + 1 to count do step session expected done;
  let live_after, heap_after = heap () in
  known session expected;
  let shown = Hashtbl.fold (fun code n list -> (code, n) :: list) seen [] |> List.sort compare in
  Printf.printf "%d messages, seed %Ld\n" count seed;
  let what code = if code = 0 then "a result" else string_of_int code in
  List.iter (fun (code, n) -> Printf.printf "%8d answers with %s\n" n (what code)) shown;
  Printf.printf "live words: %d after a fifth, %d at the end; heap %d\n" live live_after heap_after;
  if live_after > live + (live / 10) + 500_000 then fault "" "the heap has grown";
  Printf.printf "%d faults\n" !faults

let () =
  let number k default = if Array.length Sys.argv > k then Int64.of_string Sys.argv.(k) else default in
  run (Int64.to_int (number 1 20_000L)) (number 2 1L);
  exit (if !faults > 0 then 1 else 0)
