open Scc_base
open Scc_json

(* {1 Methods} *)

let protocol = 1

type work = Session.t -> seconds:float -> Read.params -> Reply.t

let evaluate (s : Session.t) ~seconds p =
  let memory = Memory.words_of_mib s.quotas.memory_mib in
  Evaluate.evaluate { seconds; memory; now = s.surroundings.now } s.models p

let check (s : Session.t) ~seconds p =
  let memory = Memory.words_of_mib s.quotas.memory_mib in
  Checks.check { seconds; memory; now = s.surroundings.now } s.models p

let describe_text (s : Session.t) ~seconds:_ p = Texts.describe ~read_file:s.surroundings.read_file p
let plain f : work = fun _ ~seconds:_ p -> f p
let on_shapes f : work = fun s ~seconds:_ p -> f s.Session.shapes p
let on_models f : work = fun s ~seconds:_ p -> f s.Session.models p

let described = "service.describe"
let discover = "rpc.discover"

let table : (string * work) list =
  [
    ("first_time_of_contact", on_shapes Contacts.first_time_of_contact);
    ("contact", on_shapes Contacts.contact);
    ("response", on_shapes Responses.response);
    ("shape.define", on_shapes Shapes.define);
    ("shape.check", plain Shapes.check);
    ("shape.mass", on_shapes Shapes.mass);
    ("shape.release", on_shapes Shapes.release);
    ("model.load", on_models Models.load);
    ("model.release", on_models Models.release);
    ("successors", on_models Runs.successors);
    ("step", on_models Runs.step);
    ("replay", on_models Runs.replay);
    ("evaluate", evaluate);
    ("values", on_models Evaluate.values);
    ("model.check", check);
    ("text.format", plain Texts.format);
    ("text.describe", describe_text);
  ]

let methods = List.sort String.compare (described :: discover :: List.map fst table)

let describe (s : Session.t) p =
  Read.only p [ "limits" ];
  Reply.Value
    (`Assoc
       [
         ("service", `String "scc-oracle");
         ("protocol", `Int protocol);
         ("version", Json.text s.version);
         ("semantics", `String Scc_calculus.Parameters.version);
         ("methods", `List (List.map (fun m -> `String m) methods));
         ("limits", `Assoc (List.map (fun (name, n) -> (name, `Int n)) (Quotas.listed s.quotas)));
       ])

let work more name : work option =
  if String.equal name described || String.equal name discover then Some (fun s ~seconds:_ p -> describe s p)
  else match List.assoc_opt name table with Some _ as found -> found | None -> List.assoc_opt name more

(* What a notification may ask for to any effect. *)
let has_effect name = String.equal name "shape.release" || String.equal name "model.release"

(* {1 Requests} *)

type request = {
  id : Wire.t option;  (** none for a notification *)
  name : string;
  members : (string * Wire.t) list;
}

let invalid why = Fault.refuse (Invalid_request why)

let id_bytes = 1024
let id_digits = 64

let is_integer s = String.length s <= id_digits && String.for_all (fun c -> c = '-' || (c >= '0' && c <= '9')) s

let good_id : Wire.t -> bool = function
  | Null -> true
  | Text s -> String.length s <= id_bytes
  | Number s -> is_integer s
  | Bool _ | List _ | Object _ -> false

(* The id to answer with, whatever else may be wrong. *)
let id_of : Wire.t -> Wire.t option = function
  | Object members -> (
      match List.assoc_opt "id" members with
      | Some id when good_id id -> Some id
      | Some _ -> Some Null
      | None -> None)
  | _ -> Some Null

let request (v : Wire.t) =
  match v with
  | Object members ->
    let find name = List.assoc_opt name members in
    let known (name, _) = List.mem name [ "jsonrpc"; "id"; "method"; "params" ] in
    if not (List.for_all known members) then invalid "a member that JSON-RPC does not know";
    (match find "id" with
     | Some id when not (good_id id) -> invalid "`id` is a string, an integer or null"
     | Some _ | None -> ());
    (match find "jsonrpc" with
     | Some (Text "2.0") -> ()
     | Some _ | None -> invalid "`jsonrpc` is \"2.0\"");
    let name = match find "method" with Some (Text s) -> s | _ -> invalid "`method` is a string" in
    let members =
      match find "params" with
      | None -> []
      | Some (Object members) -> members
      | Some (List _) -> Fault.invalid (Member "params") "params are given by name, as an object"
      | Some _ -> invalid "`params` is an object"
    in
    { id = find "id"; name; members }
  | _ -> invalid "a request is an object"

let explores name = String.equal name "evaluate" || String.equal name "model.check"

let seconds (s : Session.t) name p =
  let most = float_of_int s.quotas.seconds in
  match Read.optional p "limits" Read.fields with
  | None -> most
  | Some limits -> (
      let others = if explores name then [ "states"; "depth"; "time" ] else [] in
      Read.only limits ("seconds" :: others);
      match Read.optional limits "seconds" Read.positive with
      | None -> most
      | Some x -> Float.min most (Scc_exact.Rat.to_float x))

let shown name = if String.length name <= 64 then name else "a long name"

let answer (s : Session.t) more r =
  match work more r.name with
  | None -> Error (Fault.No_method (shown r.name))
  | Some work -> (
      let p = Read.params s.quotas r.members in
      let seconds = seconds s r.name p in
      match s.surroundings.bounded ~seconds (fun () -> work s ~seconds p) with
      | Ok reply -> Ok reply
      | Error stop ->
        Session.distrust s;
        Error (Stopped stop))

(* {1 Nothing escapes} *)

let internal s what =
  Session.distrust s;
  Error (Fault.Internal what)

(* Of what a request may raise, all but what the surroundings have to say. *)
let guarded (s : Session.t) f =
  match f () with
  | result -> result
  | exception Fault.Refused fault -> Error fault
  | exception Bug.Bug (place, what) ->
    let file, line, _, _ = place in
    internal s (Printf.sprintf "%s:%d: %s" (Filename.basename file) line what)
  | exception Stack_overflow -> internal s "stack overflow"
  | exception Out_of_memory -> internal s "no memory left"
  | exception e when not (s.surroundings.passes e) -> internal s (Printexc.to_string e)

let full (s : Session.t) = Fault.Limit ("reply_bytes", s.quotas.reply_bytes)
let is_full (s : Session.t) b = Buffer.length b > s.quotas.reply_bytes

(* Adds the answer; takes back what would make the line too long. *)
let write (s : Session.t) b ~id result =
  let start = Buffer.length b in
  let put () =
    match result with
    | Ok reply -> Reply.result b ~id reply
    | Error fault -> Reply.error b ~id fault
  in
  let spoilt fault =
    Buffer.truncate b start;
    Reply.error b ~id fault
  in
  match guarded s (fun () -> Ok (put ())) with
  | Ok () -> if Result.is_ok result && is_full s b then spoilt (full s)
  | Error fault -> spoilt fault

(* Whether something was added. *)
let one s more b v =
  let id = id_of v in
  match guarded s (fun () -> Ok (request v)) with
  | Error (Invalid_params _) when Option.is_none id -> false
  | Error fault ->
    write s b ~id:(Option.value id ~default:Wire.Null) (Error fault);
    true
  | Ok { id = None; name; _ } when not (has_effect name) -> false
  | Ok r -> (
      let result = if is_full s b then Error (full s) else guarded s (fun () -> answer s more r) in
      match r.id with
      | None -> false
      | Some id ->
        write s b ~id result;
        true)

let batch s more b requests =
  Buffer.add_char b '[';
  let add any v =
    let before = Buffer.length b in
    if any then Buffer.add_char b ',';
    let added = one s more b v in
    if not added then Buffer.truncate b before;
    any || added
  in
  let any = List.fold_left add false requests in
  Buffer.add_char b ']';
  any

let refused s b fault =
  write s b ~id:Wire.Null (Error fault);
  true

let is_blank c = c = ' ' || c = '\t' || c = '\r' || c = '\n'

let handle ?(more = []) (s : Session.t) line =
  if String.for_all is_blank line then None
  else
    let b = Buffer.create 256 in
    let some =
      match guarded s (fun () -> Wire.parse s.quotas line) with
      | Error fault -> refused s b fault
      | Ok (List []) -> refused s b (Invalid_request "an empty batch")
      | Ok (List requests) ->
        if List.compare_length_with requests s.quotas.batch > 0 then
          refused s b (Limit ("batch", s.quotas.batch))
        else batch s more b requests
      | Ok v -> one s more b v
    in
    if some then Some (Buffer.contents b) else None

let too_long (s : Session.t) =
  let b = Buffer.create 256 in
  ignore (refused s b (Limit ("line_bytes", s.quotas.line_bytes)));
  Buffer.contents b
