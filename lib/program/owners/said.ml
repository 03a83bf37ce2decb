open Scc_json
open Json_format

type order = Levels | Time | Any

type begin_ = {
  peers : (string * int) list;
  secret : string;
  run : string;
  order : order;
  states : int option;
  deadline : int;
  every : int option;
  folder : string option;
  memory : int option;
  restore : string list;
  evaluate : bool;
}

(* {1 What the parent says} *)

let address text =
  match String.rindex_opt text ':' with
  | None -> None
  | Some at ->
    let digits = String.sub text (at + 1) (String.length text - at - 1) in
    let is_digit c = '0' <= c && c <= '9' in
    let port = if String.for_all is_digit digits then int_of_string_opt digits else None in
    Option.bind port (fun port -> if 1 <= port && port <= 65535 then Some (String.sub text 0 at, port) else None)

let order_name = function Levels -> "levels" | Time -> "time" | Any -> "any"

let begin_format =
  let peer (host, port) = Printf.sprintf "%s:%d" host port in
  obj
    (let+ peers = required "peers" (list ~least:1 some_text) (fun b -> List.map peer b.peers)
     and+ secret = required "secret" some_text (fun b -> b.secret)
     and+ run = required "run" some_text (fun b -> b.run)
     and+ order = required "order" (word order_name [ Levels; Time; Any ]) (fun b -> b.order)
     and+ states = optional "states" (integer ~least:1 ()) (fun b -> b.states)
     and+ deadline = optional "deadline" natural (fun b -> Some b.deadline)
     and+ every = optional "every" natural (fun b -> b.every)
     and+ folder = optional "folder" some_text (fun b -> b.folder)
     and+ memory = optional "memory" natural (fun b -> b.memory)
     and+ restore = optional "restore" (list some_text) (fun b -> Some b.restore)
     and+ evaluate = optional "evaluate" bool (fun b -> Some b.evaluate) in
     let addresses = List.filter_map address peers in
     let all_there = List.length addresses = List.length peers in
     ( all_there,
       {
         peers = addresses; secret; run; order; states; every; folder; memory;
         deadline = Option.value deadline ~default:10_000;
         restore = Option.value restore ~default:[];
         evaluate = Option.value evaluate ~default:false;
       } ))

let refused fmt = Printf.ksprintf (fun text -> Failure.refused "the first line of the input: %s" text) fmt

let read_begin ~count line =
  let json =
    match Json.parse (Scc_base.Source.make ~name:"-" line) with
    | Ok json -> json
    | Error d -> refused "%s" d.message
  in
  match read begin_format json with
  | Error fault -> refused "%s" (fault_to_string fault)
  | Ok (all_there, b) ->
    if not all_there then refused "a peer is `host:port', with a port from 1 to 65535";
    if List.length b.peers <> count then refused "there are %d peers, and %d owners" (List.length b.peers) count;
    if (Option.is_some b.every || Option.is_some b.memory) && Option.is_none b.folder then
      refused "`every' and `memory' need a `folder'";
    b

(* {1 What is said to the parent} *)

type lasso = { choices : int list; from : int }

type found = {
  progress : Progress.t;
  runs : (int * int list) list;
  cycle : lasso option;
  conclusions : Conclusion.t list;
  messages : int;
  bytes : int;
}

type t =
  | Going of Progress.t
  | Kept of { level : int; from : int; file : string; progress : Progress.t }
  | Found of found

let explored =
  fields
    [
      field "level" natural (fun (p : Progress.t) -> p.level);
      field "depth" natural (fun (p : Progress.t) -> p.depth);
      field "states" natural (fun (p : Progress.t) -> p.states);
      field "transitions" natural (fun (p : Progress.t) -> p.transitions);
    ]

let goals (p : Progress.t) is = List.filter is (List.init (Array.length p.doubts) Fun.id)

(* In time, and not expanded. *)
let left_open (p : Progress.t) =
  let complete = p.stop = None && p.faults = [] && p.too_long = 0 in
  match p.open_ with
  | Some is_open -> goals p (fun g -> is_open.(g))
  | None -> goals p (fun g -> (not complete) && Option.is_none p.met.(g))

let kept =
  fields
    [
      field "level" natural (fun (level, _, _) -> level);
      field "from" natural (fun (_, from, _) -> from);
      field "file" some_text (fun (_, _, file) -> file);
    ]

let run =
  fields [ field "goal" natural fst; field "choices" (list natural) snd ]
  |> about "A run that meets a goal: the places of its transitions."

let cycle =
  fields
    [
      field "from" natural (fun c -> c.from);
      field "choices" (list natural) (fun c -> c.choices);
    ]
  |> about "A run that comes back, within one instant, to the state after its first `from` transitions."

let conclusion =
  let text (r : Scc_verify.Verdict.reason) = Scc_verify.Verdict.reason_to_string r in
  let told f (c : Conclusion.t) = f c.verdict in
  fields
    [
      field "check" natural (fun (c : Conclusion.t) -> c.check) ~about:"Its place among those of the header.";
      field "verdict" Scc_reports.Check_json.kind_format (told Scc_reports.Check_json.kind);
      maybe "values" Scc_reports.Check_json.values_format (told Scc_reports.Check_json.values)
        ~about:"The answer to `= ?`, as in `scc check --json`.";
      maybe "text" some_text (fun (c : Conclusion.t) ->
          match c.verdict with
          | Measured m -> Some (Scc_verify.Verdict.to_string (Measured { m with reasons = [] }))
          | Holds _ | Violated _ | Depends _ | Undecided _ -> None)
        ~about:"The answer in words, and why it is no fraction where nothing was left out.";
      field "reasons" (list some_text) (fun (c : Conclusion.t) ->
          List.map text (Scc_reports.Check_json.reasons c.verdict))
        ~about:"Why it is not better known, besides states that were not expanded.";
      field "unexplored" bool (fun (c : Conclusion.t) -> c.unexplored)
        ~about:"It is not better known since states were not expanded.";
    ]
  |> about "The verdict of a property that is more than a search."

let found =
  let p f x = f x.progress in
  fields
    [
      field "found" explored (fun x -> x.progress);
      field "stopped"
        (nullable (word Fun.id [ "early"; "states"; "levels"; "late" ]))
        (p (fun (p : Progress.t) -> Option.map Progress.stop_name p.stop));
      field "doubts" (list natural) (p (fun p -> goals p (fun g -> p.doubts.(g))));
      field "open" (list natural) (p left_open);
      field "runs" (list run) (fun x -> x.runs);
      field "cycle" (nullable cycle) (fun x -> x.cycle);
      maybe "conclusions" (list ~least:1 conclusion) (fun x ->
          match x.conclusions with [] -> None | all -> Some all)
        ~about:"With `evaluate`.";
      field "faults" (list text) (p (fun p -> p.faults));
      field "ends" (list text) (p (fun p -> p.ends));
      field "too_long" natural (p (fun p -> p.too_long));
      field "messages" natural (fun x -> x.messages);
      field "bytes" natural (fun x -> x.bytes);
    ]

let format =
  union
    [
      case (fields [ field "going" explored Fun.id ]) (function Going p -> Some p | _ -> None) ignore;
      case
        (fields [ field "kept" kept fst; field "explored" explored snd ])
        (function Kept k -> Some ((k.level, k.from, k.file), k.progress) | _ -> None)
        ignore;
      case found (function Found f -> Some f | _ -> None) ignore;
    ]
  |> about "A line of an owner, after its header." |> named ~file:"successors" "owner_line"

let line t = Json.line (write format t)
