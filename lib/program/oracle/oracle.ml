open Scc_base
open Scc_json.Json_format

(* {1 Methods} *)

let protocol = 1

type work = Session.t -> seconds:float -> Read.params -> Reply.t

(* What a method needs of a session. *)
let on part (m : _ Method.t) = { m with work = (fun (s, seconds) p -> m.work (part s seconds) p) }

let shapes m = on (fun (s : Session.t) _ -> s.shapes) m
let models m = on (fun (s : Session.t) _ -> s.models) m
let plain m = on (fun _ _ -> ()) m
let files m = on (fun (s : Session.t) _ -> s.surroundings.read_file) m

let explores m =
  let bounds (s : Session.t) seconds =
    let memory = Memory.words_of_mib s.quotas.memory_mib in
    ({ Evaluate.seconds; memory; now = s.surroundings.now }, s.models)
  in
  on bounds m

let undescribed : (Session.t * float) Method.t list =
  [
    shapes Contacts.first_time_of_contact; shapes Contacts.contact; shapes Responses.response;
    shapes Shapes.define; plain Shapes.check; shapes Shapes.mass; shapes Shapes.release; models Models.load;
    models Models.release; models Runs.successors; models Runs.step; models Runs.replay;
    explores Evaluate.evaluate; models Evaluate.values; explores Checks.check; plain Texts.format;
    files Texts.describe; files Texts.complete; files Texts.fixes;
  ]

let described = [ "rpc.discover"; "service.describe" ]
let method_name (m : _ Method.t) = m.name
let methods = List.sort String.compare (described @ List.map method_name undescribed)

let describe =
  let params = [ Method.limits ] in
  let result =
    fields
      [
        fixed "service" (`String "scc-oracle");
        fixed "protocol" (`Int protocol);
        field "version" text (fun (s : Session.t) -> s.version);
        Scc_runs.Shared.semantics ();
        field "methods" (list text) (fun _ -> methods);
        field "limits" (entries natural) (fun (s : Session.t) -> Quotas.listed s.quotas);
      ]
  in
  let result = Scc_json.Json_format.named ~file:Read.file "description" result in
  fun name -> Method.make name params result (fun (s, _) _ -> s)

let table = List.map describe described @ undescribed

let work more name : work option =
  match List.find_opt (fun m -> String.equal name (method_name m)) table with
  | Some m -> Some (fun s ~seconds p -> m.work (s, seconds) p)
  | None -> List.assoc_opt name more

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
  let limits = if explores name then Method.all_limits else Method.plain_limits in
  match Option.bind (Read.optional p limits) (fun limits -> Read.optional limits Method.seconds) with
  | None -> most
  | Some x -> Float.min most (Scc_exact.Rat.to_float x)

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

(* {1 The schema} *)

let schema_file : Scc_json.Json_schema.file =
  let open Scc_json in
  let defined = Read.defined in
  let constant text : Json_schema.t = Constant [ `String text ] in
  let member required name value : Json_schema.member = { name; required; value } in
  let id = defined "id" (Json_schema.Any_of [ Text { least = 0 }; Integer { least = None; most = None }; Null ]) in
  let params (m : _ Method.t) = defined (m.name ^ ".params") (Members m.params) in
  let result (m : _ Method.t) = defined (m.name ^ ".result") m.result in
  let anything = Json_schema.Entries Anything in
  let of_method (m : _ Method.t) : Json.t =
    let reference = `String (Printf.sprintf "#/$defs/%s.params" m.name) in
    let properties =
      [ ("method", `Assoc [ ("const", `String m.name) ]); ("params", `Assoc [ ("$ref", reference) ]) ]
    in
    `Assoc [ ("properties", `Assoc properties) ]
  in
  let version = member true "jsonrpc" (constant "2.0") in
  let request =
    Json_schema.Members
      [ version; member false "id" id; member true "method" (Text { least = 0 }); member false "params" anything ]
  in
  let request =
    defined "request" (Also ([ ("anyOf", `List (List.map of_method table)) ], request))
  in
  let answer name value = Json_schema.Members [ version; member true "id" id; member true name value ] in
  let answers = [ answer "result" anything; answer "error" (schema Fault.format) ] in
  let response =
    defined "response" (About ("The answer to a request; result is described by METHOD.result.", Any_of answers))
  in
  let some each = Json_schema.Items { each; least = 1; most = None; distinct = false } in
  {
    name = "oracle";
    title = "Messages of scc oracle: a line to it, or from it";
    root = Some (Any_of [ request; some request; response; some response ]);
    parts = List.map params table @ List.map result table;
  }
