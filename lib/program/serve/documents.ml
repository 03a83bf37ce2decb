open Lwt.Syntax
open Scc_json

type state = Working | Ready of (string * Json.t) list | Refused of Json.t | Over of string

type document = {
  id : string;
  child : Child.t;
  mutable state : state;
  mutable progress : string option;
  mutable interrupted : bool;
  news : unit Lwt_condition.t;
  mutable used : int;  (** when it was asked for last, by a count of all that was asked *)
}

type t = { mutable all : document list; mutable count : int; mutable clock : int }

let most = 12

(* Seconds for an answer: the process itself gives a question up after a minute. *)
let patience = 75.

let create () = { all = []; count = 0; clock = 0 }

let touch t d =
  t.clock <- t.clock + 1;
  d.used <- t.clock

let find t id =
  let found = List.find_opt (fun d -> String.equal d.id id) t.all in
  Option.iter (touch t) found;
  found

let close t d =
  t.all <- List.filter (fun other -> not (String.equal other.id d.id)) t.all;
  Child.discard d.child

let close_all t = Lwt.join (List.map (close t) t.all)

let is_working d = match d.state with Working -> true | Ready _ | Refused _ | Over _ -> false
let is_ready d = match d.state with Ready _ -> true | Working | Refused _ | Over _ -> false

(* {1 What a process tells while it makes its document} *)

let enter d state =
  d.state <- state;
  Lwt_condition.broadcast d.news ()

let unexpected = Over "its process ended unexpectedly"

(* Whether it goes on. *)
let heard d line =
  match Yojson.Basic.from_string line with
  | `Assoc [ ("progress", `String text) ] ->
    d.progress <- Some text;
    Lwt_condition.broadcast d.news ();
    true
  | `Assoc [ ("ready", `Assoc members) ] ->
    enter d (Ready members);
    false
  | `Assoc [ ("refused", found) ] ->
    enter d (Refused found);
    false
  | _ | (exception Yojson.Json_error _) ->
    enter d unexpected;
    false

let rec listen d =
  let* line = Child.hear d.child in
  match line with
  | Some line -> if heard d line then listen d else Lwt.return_unit
  | None ->
    enter d unexpected;
    Lwt.return_unit

(* {1 Opening} *)

(* Room for one more, if there can be. *)
let make_room t =
  if List.length t.all < most then true
  else
    let idle = List.filter (fun d -> not (is_working d)) t.all in
    let older a b = if b.used < a.used then b else a in
    match idle with
    | [] -> false
    | first :: rest ->
      Lwt.async (fun () -> close t (List.fold_left older first rest));
      true

let opened t arguments ~text =
  if not (make_room t) then None
  else begin
    t.count <- t.count + 1;
    let d =
      {
        id = Printf.sprintf "d%d" t.count;
        child = Child.start arguments;
        state = Working;
        progress = None;
        interrupted = false;
        news = Lwt_condition.create ();
        used = 0;
      }
    in
    touch t d;
    t.all <- d :: t.all;
    Lwt.async (fun () ->
        let* () = Child.say d.child (Json.line (Json.text text)) in
        listen d);
    Some d.id
  end

(* {1 Asking} *)

let json d : Json.t =
  let text = Json.option Json.text in
  let state, more =
    match d.state with
    | Working -> ("working", [ ("progress", text d.progress) ])
    | Ready members -> ("ready", members)
    | Refused found -> ("refused", [ ("diagnostics", found) ])
    | Over why -> ("over", [ ("why", Json.text why) ])
  in
  `Assoc (("state", `String state) :: more)

let status d ~seconds =
  let wait () =
    Lwt.catch
      (fun () -> Lwt_unix.with_timeout seconds (fun () -> Lwt_condition.wait d.news))
      (fun _ -> Lwt.return_unit)
  in
  let* () = if is_working d then wait () else Lwt.return_unit in
  Lwt.return (json d)

(* Once: a second signal would end the process, with all that it has found. *)
let interrupt d =
  if is_working d && not d.interrupted then begin
    d.interrupted <- true;
    Child.interrupt d.child
  end

let ask d line =
  let* answer = Child.ask d.child ~seconds:patience line in
  (match answer with
   | Ok _ | Error Busy -> ()
   | Error Over -> enter d unexpected
   | Error Too_slow -> enter d (Over "its process did not answer in time, and was ended"));
  Lwt.return answer
