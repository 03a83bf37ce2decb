open Scc_base

(* The database tells that it is one of these by this number, and by the version of its tables. *)
let application = 0x53434331
let version = 2
let file = "explorations.sqlite"

(* Milliseconds. *)
let patience = 2000

type t = {
  folder : string;
  db : Database.t option;  (** [None]: it could not be written to from the beginning *)
  writable : bool;
  identity : string;  (** a digest, on which those of the blocks rest *)
  begun : (string, int) Hashtbl.t;  (** how many explorations of each name *)
  warn : Diag.t -> unit;
  mutable failed : Diag.t option;
}

let at folder = Span.of_file folder
let fail = Database.fail
let damaged = Database.damaged

(** {2 Opening} *)

(* No permission is missing, but room. *)
let is_full : Unix.error -> bool = function
  | ENOSPC | EFBIG | EIO -> true
  | EUNKNOWNERR n -> n = 122 (* EDQUOT *)
  | _ -> false

let may what f =
  match f () with
  | x -> x
  | exception (Unix.Unix_error ((EMFILE | ENFILE), _, _) as lacking) -> raise lacking
  | exception Unix.Unix_error (error, _, _) ->
    let code = if is_full error then Code.cannot_write else Code.no_store in
    fail code "%s: %s" what (Unix.error_message error)
  | exception (Sys_error text as e) ->
    if Option.is_some (Scc_system.Resources.refused e) then raise e else fail Code.no_store "%s: %s" what text

let make_folder folder =
  match Sys.is_directory folder with
  | true -> ()
  | false -> fail Code.no_store "it is a file, and a store is a folder"
  | exception Sys_error _ -> may "the folder cannot be made" (fun () -> Unix.mkdir folder 0o777)

let can path permissions =
  match Unix.access path permissions with () -> Ok () | exception Unix.Unix_error (error, _, _) -> Error error

let or_else what = function
  | Ok () -> ()
  | Error error -> fail Code.no_store "%s: %s" what (Unix.error_message error)

(* A folder that is there holds a store, or nothing. Whether its files can be written to: SQLite would tell of an
   input or output that failed. *)
let may_be_store folder =
  or_else "the folder cannot be read" (can folder [ R_OK; X_OK ]);
  let entries = may "the folder cannot be read" (fun () -> Sys.readdir folder) in
  let n = String.length file in
  let own name = String.length name >= n && String.equal (String.sub name 0 n) file in
  if Array.length entries > 0 && not (Array.exists own entries) then
    fail Code.no_store "the folder holds other things, and is no store";
  let files = List.map (Filename.concat folder) (List.filter own (Array.to_list entries)) in
  List.iter (fun path -> or_else "the store cannot be read" (can path [ R_OK ])) files;
  if not (Sys.file_exists (Filename.concat folder file)) then
    or_else "the folder cannot be written to" (can folder [ W_OK ]);
  List.for_all (fun path -> Result.is_ok (can path [ W_OK ])) (folder :: files)

let tables db =
  let add acc row = Sqlite3.column_text row 0 :: acc in
  List.rev (Database.fold db "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name" [] add [])

let own_tables = [ "blocks"; "identity" ]

let is_ours db =
  let id = Database.number db "PRAGMA application_id" in
  let tables = tables db in
  if id = 0 && tables = [] then false
  else if id <> application then
    if tables = own_tables then damaged "its header tells of another program"
    else fail Code.no_store "its database is not one that scc has made"
  else
    match Database.number db "PRAGMA user_version" with
    | v when v <> version -> fail Code.other_store "it is of version %d, and this scc keeps version %d" v version
    | _ when tables <> own_tables -> damaged "its tables are not there"
    | _ -> true

let create db identity =
  Database.run db (Printf.sprintf "PRAGMA application_id = %d" application);
  Database.run db (Printf.sprintf "PRAGMA user_version = %d" version);
  Database.run db "CREATE TABLE identity (name TEXT PRIMARY KEY, value TEXT NOT NULL)";
  Database.run db
    "CREATE TABLE blocks (exploration TEXT NOT NULL, number INTEGER NOT NULL, digest BLOB NOT NULL, \
     bytes BLOB NOT NULL, PRIMARY KEY (exploration, number))";
  List.iter
    (fun (name, value) ->
       Database.change db "INSERT INTO identity VALUES (?, ?)" [ Sqlite3.Data.TEXT name; Sqlite3.Data.TEXT value ])
    identity

let recorded db =
  let add acc row = (Sqlite3.column_text row 0, Sqlite3.column_text row 1) :: acc in
  List.rev (Database.fold db "SELECT name, value FROM identity ORDER BY rowid" [] add [])

let shown value = if String.equal value "" then "empty" else value

let same_identity kept identity =
  let differs (name, value) =
    match List.assoc_opt name kept with
    | Some known when String.equal known value -> None
    | Some known -> Some (Printf.sprintf "%s is %s there, and %s here" name (shown known) (shown value))
    | None -> Some (Printf.sprintf "nothing is known there of %s" name)
  in
  let only_kept (name, value) =
    if List.mem_assoc name identity then None
    else if String.equal value "" then Some (Printf.sprintf "%s is given there, and not here" name)
    else Some (Printf.sprintf "%s is %s there, and not given here" name value)
  in
  let other what = fail Code.other_store "it keeps something else: %s" what in
  Option.iter other (List.find_map differs identity);
  Option.iter other (List.find_map only_kept kept)

let digest_of_identity identity =
  let told text = Printf.sprintf "%d:%s" (String.length text) text in
  Digest.string (String.concat "" (List.map (fun (name, value) -> told name ^ told value) identity))

let first_link identity exploration = Digest.string (identity ^ exploration)
let link before bytes = Digest.string (before ^ Digest.string bytes)

(** {2 Blocks} *)

(* Whether each block is what was written, and follows the one before it. *)
let look_at_blocks db identity =
  let add (exploration, next, before) row =
    let e = Sqlite3.column_text row 0 in
    let next, before = if exploration = Some e then (next, before) else (0, first_link identity e) in
    let digest = link before (Sqlite3.column_blob row 3) in
    let is_next = match Sqlite3.column row 1 with INT n -> Int64.equal n (Int64.of_int next) | _ -> false in
    if not (is_next && String.equal digest (Sqlite3.column_blob row 2)) then
      damaged (Printf.sprintf "block %d of the exploration of %s is not what was written" next e);
    (Some e, next + 1, digest)
  in
  ignore
    (Database.fold db "SELECT exploration, number, digest, bytes FROM blocks ORDER BY exploration, number" [] add
       (None, 0, identity))

(* That it is whole, and of this. Its blocks rest on what it says that it is of, so that this is compared once it
   is known to be what was written. *)
let look_at db identity =
  Database.look_through db;
  let kept = recorded db in
  look_at_blocks db (digest_of_identity kept);
  same_identity kept identity

(* Nothing is changed of a file that is not ours. From the first look on nobody else can write to it: of two that
   come at once to one that is not made yet, one does not get to the transaction. *)
let begin_to_write db identity =
  Database.run db "PRAGMA locking_mode = EXCLUSIVE";
  let there = is_ours db in
  if there then look_at db identity;
  (* Blocks are long: fewer pages are fewer writes. Of a file that is there it stays as it is. *)
  Database.run db "PRAGMA page_size = 16384";
  Database.run db "BEGIN IMMEDIATE";
  Sqlite3.busy_timeout db patience;
  if not there then create db identity;
  Database.run db "COMMIT";
  Database.run db "PRAGMA journal_mode = WAL";
  Database.run db "PRAGMA synchronous = FULL"

let begin_to_read db identity =
  if not (is_ours db) then fail Code.no_store "the store cannot be written to, and has nothing yet";
  look_at db identity

let make folder ~db ~writable ~identity ~warn =
  { folder; db; writable; identity; begun = Hashtbl.create 8; warn; failed = None }

let connect folder identity warn =
  make_folder folder;
  let writable = may_be_store folder in
  let path = Filename.concat folder file in
  let db = if writable then Database.open_to_write path else Database.open_to_read path in
  match if writable then begin_to_write db identity else begin_to_read db identity with
  | () ->
    let identity = digest_of_identity identity in
    make folder ~db:(Some db) ~writable ~identity ~warn
  | exception e ->
    Database.close db;
    raise e

(** {2 Use} *)

let folder t = t.folder
let failed t = t.failed

let key exploration number = [ Sqlite3.Data.TEXT exploration; INT (Int64.of_int number) ]

let database t =
  match t.db with Some db -> db | None -> fail Code.cannot_write "the store could not be written to"

let read t exploration number =
  let take _ row = Some (Sqlite3.column_blob row 0, Sqlite3.column_blob row 1) in
  Database.fold (database t) "SELECT digest, bytes FROM blocks WHERE exploration = ? AND number = ?"
    (key exploration number) take None

let write t exploration number digest bytes =
  Database.change (database t) "INSERT INTO blocks VALUES (?, ?, ?, ?)"
    (key exploration number @ [ Sqlite3.Data.BLOB digest; BLOB bytes ])

(* What was kept up to now stays; a hole would make all after it worthless. *)
let give_up t text =
  t.failed <-
    Some
      (Diag.error Code.cannot_write (at t.folder) "%s; what was found from then on is not kept" text
         ~hint:"the same command goes on from what was kept, once the store can be written again");
  t.warn
    (Diag.warning Code.cannot_write (at t.folder) "%s: what is found from now on is not kept" text
       ~hint:"it goes on all the same; what was kept up to now stays")

(* It was whole when it was opened. What was found from it is right, and so is what is found without it. *)
let damaged_meanwhile t text =
  let hint = "it goes on all the same; remove the folder to begin anew" in
  t.failed <- Some (Diag.error Code.damaged_store (at t.folder) "%s; it is not used any more" text ~hint);
  t.warn (Diag.warning Code.damaged_store (at t.folder) "%s: it is not used any more" text ~hint)

let trouble t (code, text) = if code = Code.damaged_store then damaged_meanwhile t text else give_up t text

(* Without a store the work is the same: what cannot be written at the beginning is treated as what cannot be
   written later. *)
let openly folder ~identity ~warn =
  match Database.caught (fun () -> connect folder identity warn) with
  | Ok t -> Ok t
  | Error (code, text) when code = Code.cannot_write ->
    let t = make folder ~db:None ~writable:false ~identity:"" ~warn in
    give_up t text;
    Ok t
  | Error (code, text) -> Error (Diag.error code (at folder) "%s" text)

(* Later on a lack of descriptors is no reason to end. *)
let caught f =
  match Database.caught f with
  | result -> result
  | exception Unix.Unix_error (error, _, _) ->
    Error (Code.cannot_write, "the store cannot be used: " ^ Unix.error_message error)

let log t name : Scc_parallel.Log.t =
  let before = Option.value (Hashtbl.find_opt t.begun name) ~default:0 in
  Hashtbl.replace t.begun name (before + 1);
  let exploration = if before = 0 then name else Printf.sprintf "%s#%d" name (before + 1) in
  let number = ref 0 and last = ref (first_link t.identity exploration) in
  let follow digest =
    incr number;
    last := digest
  in
  let next () =
    match if Option.is_some t.failed then Ok None else caught (fun () -> read t exploration !number) with
    | Ok None -> None
    | Ok (Some (digest, bytes)) ->
      follow digest;
      Some bytes
    | Error why ->
      trouble t why;
      None
  in
  let keep bytes =
    if Option.is_none t.failed then begin
      let digest = link !last bytes in
      let write () =
        if not t.writable then fail Code.no_store "the store is read-only";
        write t exploration !number digest bytes
      in
      match caught write with Ok () -> follow digest | Error why -> trouble t why
    end
  in
  { next; keep }

let close t = Option.iter Database.close t.db
