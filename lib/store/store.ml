open Scc_base

(* The database tells that it is one of these by this number, and by the version of its tables. *)
let application = 0x53434331
let version = 1
let file = "explorations.sqlite"

(* Milliseconds. *)
let patience = 2000

type t = {
  folder : string;
  db : Sqlite3.db;
  identity : string;  (** a digest, on which those of the blocks rest *)
  had_blocks : bool;
  begun : (string, int) Hashtbl.t;  (** how many explorations of each name *)
  warn : Diag.t -> unit;
  mutable failed : Diag.t option;
}

exception Failed of Code.t * string  (** what is wrong *)

let at folder = Span.make ~file:folder ~start:0 ~stop:0
let fail code format = Printf.ksprintf (fun text -> raise (Failed (code, text))) format

let damaged what = fail Code.damaged_store "the store is damaged: %s" what

(** {2 SQLite} *)

(* What SQLite answers when it should not. *)
let refuse db (rc : Sqlite3.Rc.t) =
  let text = Sqlite3.errmsg db in
  match rc with
  | BUSY | LOCKED -> fail Code.no_store "another process has this store"
  | CORRUPT | NOTADB | MISMATCH -> damaged text
  | _ -> fail Code.no_store "the store cannot be used: %s" text

let check db (rc : Sqlite3.Rc.t) = match rc with OK | DONE | ROW -> () | _ -> refuse db rc
let run db sql = check db (Sqlite3.exec db sql)

(* The rows of a query; a damaged file may show itself at any of them. *)
let with_statement db sql values use =
  let statement = Sqlite3.prepare db sql in
  Fun.protect
    ~finally:(fun () -> ignore (Sqlite3.finalize statement))
    (fun () ->
       List.iteri (fun i v -> check db (Sqlite3.bind statement (i + 1) v)) values;
       use statement)

let fold db sql values add start =
  with_statement db sql values (fun statement ->
      let rec rows acc =
        match Sqlite3.step statement with
        | ROW -> rows (add acc statement)
        | DONE -> acc
        | rc -> refuse db rc
      in
      rows start)

let change db sql values = with_statement db sql values (fun statement -> check db (Sqlite3.step statement))

let number db sql =
  fold db sql [] (fun _ row -> match Sqlite3.column row 0 with INT n -> Int64.to_int n | _ -> 0) 0

(** {2 Opening} *)

let may what f =
  match f () with
  | x -> x
  | exception Unix.Unix_error (error, _, _) -> fail Code.no_store "%s: %s" what (Unix.error_message error)
  | exception Sys_error text -> fail Code.no_store "%s: %s" what text

let make_folder folder =
  match Sys.is_directory folder with
  | true -> ()
  | false -> fail Code.no_store "it is a file, and a store is a folder"
  | exception Sys_error _ -> may "the folder cannot be made" (fun () -> Unix.mkdir folder 0o777)

(* A folder that is there holds a store, or nothing. *)
let may_be_store folder =
  may "the folder cannot be read" (fun () -> Unix.access folder [ R_OK; X_OK ]);
  let entries = may "the folder cannot be read" (fun () -> Sys.readdir folder) in
  let n = String.length file in
  let own name = String.length name >= n && String.equal (String.sub name 0 n) file in
  if Array.length entries > 0 && not (Array.exists own entries) then
    fail Code.no_store "the folder holds other things, and is no store";
  (* SQLite would tell of an input or output that failed. *)
  may "the folder cannot be written to" (fun () -> Unix.access folder [ W_OK ]);
  let writable name =
    if own name then
      may "the store cannot be written to" (fun () -> Unix.access (Filename.concat folder name) [ R_OK; W_OK ])
  in
  Array.iter writable entries

let is_ours db =
  let id = number db "PRAGMA application_id" in
  let tables = number db "SELECT count(*) FROM sqlite_schema" in
  if id = 0 && tables = 0 then false
  else if id <> application then fail Code.no_store "its database is not one that scc has made"
  else
    match number db "PRAGMA user_version" with
    | v when v = version -> true
    | v -> fail Code.other_store "it is of version %d, and this scc keeps version %d" v version

let create db identity =
  run db (Printf.sprintf "PRAGMA application_id = %d" application);
  run db (Printf.sprintf "PRAGMA user_version = %d" version);
  run db "CREATE TABLE identity (name TEXT PRIMARY KEY, value TEXT NOT NULL)";
  run db
    "CREATE TABLE blocks (exploration TEXT NOT NULL, number INTEGER NOT NULL, digest BLOB NOT NULL, \
     bytes BLOB NOT NULL, PRIMARY KEY (exploration, number))";
  List.iter
    (fun (name, value) ->
       change db "INSERT INTO identity VALUES (?, ?)" [ Sqlite3.Data.TEXT name; Sqlite3.Data.TEXT value ])
    identity

let recorded db =
  let add acc row = (Sqlite3.column_text row 0, Sqlite3.column_text row 1) :: acc in
  List.rev (fold db "SELECT name, value FROM identity ORDER BY rowid" [] add [])

let same_identity db identity =
  let kept = recorded db in
  let differs (name, value) =
    match List.assoc_opt name kept with
    | Some known when String.equal known value -> None
    | Some known -> Some (Printf.sprintf "%s is %s there, and %s here" name known value)
    | None -> Some (Printf.sprintf "nothing is known there of %s" name)
  in
  match List.find_map differs identity with
  | Some what -> fail Code.other_store "it keeps something else: %s" what
  | None -> if List.compare_lengths kept identity <> 0 then damaged "what it is of is not whole"

let digest_of_identity identity =
  let told text = Printf.sprintf "%d:%s" (String.length text) text in
  Digest.string (String.concat "" (List.map (fun (name, value) -> told name ^ told value) identity))

let first_link identity exploration = Digest.string (identity ^ exploration)
let link before bytes = Digest.string (before ^ Digest.string bytes)

(** {2 Blocks} *)

(* Whether each block is what was written, and follows the one before it. *)
let look_at_blocks db identity =
  let add (exploration, next, before) row =
    let e = Sqlite3.column_text row 0 and n = Sqlite3.column_int row 1 in
    let next, before = if exploration = Some e then (next, before) else (0, first_link identity e) in
    let digest = link before (Sqlite3.column_blob row 3) in
    if n <> next || not (String.equal digest (Sqlite3.column_blob row 2)) then
      damaged (Printf.sprintf "block %d of the exploration of %s is not what was written" n e);
    (Some e, n + 1, digest)
  in
  let exploration, _, _ =
    fold db "SELECT exploration, number, digest, bytes FROM blocks ORDER BY exploration, number" [] add
      (None, 0, identity)
  in
  Option.is_some exploration

let connect folder identity warn =
  make_folder folder;
  may_be_store folder;
  let db =
    match Sqlite3.db_open (Filename.concat folder file) with
    | db -> db
    | exception Sqlite3.Error text -> fail Code.no_store "the store cannot be opened: %s" text
  in
  match
    (* Nothing is changed of a file that is not ours. From the first look on nobody else can write to it: of two
       that come at once to one that is not made yet, one does not get to the transaction. *)
    run db "PRAGMA locking_mode = EXCLUSIVE";
    let there = is_ours db in
    if there then same_identity db identity;
    (* Blocks are long: fewer pages are fewer writes. Of a file that is there it stays as it is. *)
    run db "PRAGMA page_size = 16384";
    run db "BEGIN IMMEDIATE";
    Sqlite3.busy_timeout db patience;
    if not there then create db identity;
    run db "COMMIT";
    run db "PRAGMA journal_mode = WAL";
    run db "PRAGMA synchronous = FULL";
    let identity = digest_of_identity identity in
    let had_blocks = look_at_blocks db identity in
    { folder; db; identity; had_blocks; begun = Hashtbl.create 8; warn; failed = None }
  with
  | t -> t
  | exception e ->
    ignore (Sqlite3.db_close db);
    raise e

let openly folder ~identity ~warn =
  match connect folder identity warn with
  | t -> Ok t
  | exception Failed (code, text) -> Error (Diag.error code (at folder) "%s" text)
  | exception Sqlite3.Error text ->
    Error (Diag.error Code.damaged_store (at folder) "the store is damaged: %s" text)

(** {2 Use} *)

let folder t = t.folder
let resumed t = t.had_blocks
let failed t = t.failed

let key exploration number = [ Sqlite3.Data.TEXT exploration; INT (Int64.of_int number) ]

let read t exploration number =
  let take _ row = Some (Sqlite3.column_blob row 0, Sqlite3.column_blob row 1) in
  fold t.db "SELECT digest, bytes FROM blocks WHERE exploration = ? AND number = ?" (key exploration number) take
    None

let write t exploration number digest bytes =
  change t.db "INSERT INTO blocks VALUES (?, ?, ?, ?)"
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

let log t name : Scc_expand.Log.t =
  let before = Option.value (Hashtbl.find_opt t.begun name) ~default:0 in
  Hashtbl.replace t.begun name (before + 1);
  let exploration = if before = 0 then name else Printf.sprintf "%s#%d" name (before + 1) in
  let number = ref 0 and last = ref (first_link t.identity exploration) in
  let follow digest =
    incr number;
    last := digest
  in
  let next () =
    Option.map
      (fun (digest, bytes) ->
         follow digest;
         bytes)
      (read t exploration !number)
  in
  let keep bytes =
    if Option.is_none t.failed then begin
      let digest = link !last bytes in
      match write t exploration !number digest bytes with
      | () -> follow digest
      | exception (Failed (_, text) | Sqlite3.Error text) -> give_up t text
    end
  in
  { next; keep }

let close t = ignore (Sqlite3.db_close t.db)
