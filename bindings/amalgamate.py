#!/usr/bin/env python3
"""usage: amalgamate.py [output-folder], from the top folder; the default is build/amalgamation

Writes the library as two files, cairn.c and cairn.h, for programs that compile it as one file of their own.

The output begins with the headers that have an include guard, each once, in the order of their includes. Then come the .c
files. Headers without a guard (kernels), base/wide.h and what includes them depend on CNI_WIDTH: their text is put into each
.c file that includes them. The file-scope names of a .c file and of these headers get a prefix, <folder>_<file>_, as one
translation unit may define a name once only; their macros are undefined at the end of the file.

Needs Python's standard library only. Stops with a sentence at anything that it cannot do right."""
import re
import sys
from pathlib import Path

FOLDERS = 'base geometry collision linear broadphase model contacts narrowphase joints direct step world query save'.split()
SOURCE = Path('src')
TOKEN = re.compile(r'#[ \t]*pragma[^\n]*|/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|\.?\d(?:[eE][+-]|[\w.])*|[A-Za-z_]\w*|\s+|.', re.S)
INCLUDE = re.compile(r'^#include "([^"]+)"[^\n]*\n', re.M)
DEFINE = re.compile(r'^[ \t]*#[ \t]*define[ \t]+(\w+)', re.M)
DIRECTIVE = re.compile(r'^[ \t]*#(?:[^\n]*\\\n)*[^\n]*', re.M)
# Macros that system headers read: the output defines them before its first include.
SYSTEM_MACROS = {'_POSIX_C_SOURCE', '_WIN32_WINNT', 'WIN32_LEAN_AND_MEAN'}
KEYWORDS = set('const void static inline struct union enum extern volatile'.split())

PREAMBLE = '''/*
 * cairn.c - Cairn %s in one file: all of src/, written by `make amalgamation`. Never edit it.
 *
 * Compile this file by itself, as C99 or later, and add it and cairn.h to your program:
 *     cc -O3 -std=c99 -c cairn.c && cc your.c cairn.o -lm -lpthread
 * CN_NO_THREADS, CN_NO_SIMD and CN_NO_CLOCK work as in the library.
 */
#ifndef CN_BUILD
#define CN_BUILD
#endif
#if defined(_WIN32)
#ifndef _WIN32_WINNT
#define _WIN32_WINNT 0x0600
#endif
#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#elif !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#if defined(__cplusplus) && defined(__GNUC__) /* what C++'s compilers say of good C */
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wmissing-braces"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wpedantic"
#endif
#if defined(__clang__)
#pragma clang diagnostic ignored "-Wunused-function" /* inline functions of a header that nobody calls at some width */
#endif
'''


def stop(sentence):
	sys.exit('amalgamate.py: ' + sentence)


def read(name):
	path = SOURCE / name
	if not path.exists():
		stop('there is no src/%s' % name)
	return path.read_text(encoding='utf-8')


def has_guard(text):
	return re.search(r'^#ifndef (CNI_\w+_H)\n#define \1$', text, re.M) is not None


def without_comments(text):
	"""Comments and literals become one space each, so that no word in them is a name."""
	return ''.join(' ' if t[:2] in ('/*', '//') or t[0] in '"\'' else t for t in TOKEN.findall(text))


class Headers:
	def __init__(self):
		self.text, self.once = {}, {}

	def load(self, name):
		if name not in self.text:
			self.text[name] = read(name)
			self.once[name] = has_guard(self.text[name]) and not re.search(r'\bCNI_WIDTH\b', without_comments(self.text[name]))
			for other in self.includes(name):
				self.load(other)
				if self.once[name] and not self.once[other]:
					stop('src/%s has a guard but includes src/%s, which is included once per vector width' % (name, other))
		return self.text[name]

	def includes(self, name):
		return [h for h in INCLUDE.findall(self.text[name]) if h != 'cairn.h']

	def ordered(self):
		"""Headers with a guard, each after those that it includes."""
		done, order = set(), []

		def visit(name, path):
			if name in path:
				stop('src/%s includes itself' % name)
			if name in done or not self.once[name]:
				return
			for other in self.includes(name):
				visit(other, path | {name})
			done.add(name)
			order.append(name)
		for name in sorted(self.text, key=lambda n: (FOLDERS.index(n.split('/')[0]), n)):
			visit(name, frozenset())
		return order


def inlined(text, headers, seen):
	"""The text of a .c file, with the headers that are not written once in place of their include lines."""
	def replace(match):
		name = match.group(1)
		if name == 'cairn.h' or headers.once[name]:
			return ''
		if has_guard(headers.text[name]):
			if name in seen:
				return ''
			seen.add(name)
		return '/* -- src/%s */\n' % name + inlined(headers.text[name], headers, seen)
	return INCLUDE.sub(replace, text)


def declarations(text):
	"""Declarations at file scope: (text outside of braces with {} for each body, texts of these bodies)."""
	text = DIRECTIVE.sub('', without_comments(text))
	head, bodies, depth, start = '', [], 0, 0
	for k, c in enumerate(text):
		if c == '}' and text[k - 1] == '\n' and depth > 1:
			depth = 1 # an #if with a brace in both branches
		if c == '{':
			if depth == 0:
				start = k + 1
			depth += 1
		elif c == '}':
			depth -= 1
			if depth == 0:
				bodies.append(text[start:k])
				head += '{}'
				if re.search(r'\)\s*\{\}$', head) and '=' not in head:
					yield head, bodies
					head, bodies = '', []
		elif depth == 0 and c == ';':
			yield head, bodies
			head, bodies = '', []
		elif depth == 0:
			head += c


def without_attributes(head):
	head = re.sub(r'\b(__attribute__|__declspec|CNI_ALIGNED|CNI_THREAD_LOCAL)\s*(\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\))?', ' ', head)
	head = re.sub(r'\[[^\]]*\]', '', head)
	return ' '.join(head.split())


def declared(head, bodies, known):
	"""Names that one declaration at file scope defines for this file only."""
	head = without_attributes(head)
	names = set()
	tag = re.match(r'(?:typedef )?(?:static )?(?:const )?(struct|union|enum)(?: (\w+))?', head)
	if tag:
		if tag.group(2) and tag.group(2) not in known:
			names.add(tag.group(2))
		if tag.group(1) == 'enum' and bodies:
			names |= {re.match(r'\s*(\w+)', part).group(1) for part in bodies[0].split(',') if part.strip()}
	if not re.match(r'typedef|static|CNI_INLINE', head):
		return names
	function_pointer = re.search(r'\(\s*\*(?:\s*const)?\s*(\w+)', head)
	call = re.match(r'[^(=]*?(\w+) ?\(', head)
	if function_pointer and (call is None or function_pointer.start() < call.end() + 1):
		return names | {function_pointer.group(1)}
	if call:
		return names | {call.group(1)}
	for part in head.split(','):
		words = re.findall(r'[A-Za-z_]\w*', part.split('=')[0])
		if words and words[-1] not in KEYWORDS:
			names.add(words[-1])
	return names


def renamed(text, prefix, names, known):
	"""Names get the prefix, except attributes, and members after . and -> that may be those of a header's struct."""
	out, last, depth = [], '', 0
	for token in TOKEN.findall(text):
		if last == '__attribute__' or depth > 0:
			depth += (token == '(') - (token == ')')
		kept = token not in names or depth > 0 or (token in known and last in ('.', '->'))
		out.append(token if kept else prefix + token)
		if not token.isspace() and token[:2] not in ('/*', '//'):
			last = '->' if token == '>' and last == '-' else token
	return ''.join(out)


def source_text(name, headers, known, used):
	text = inlined(read(name), headers, set())
	prefix = name[:-2].replace('/', '_') + '_'
	names = set()
	for head, bodies in declarations(text):
		names |= declared(head, bodies, known)
	macros = [m for m in dict.fromkeys(DEFINE.findall(text)) if m not in SYSTEM_MACROS]
	for macro in SYSTEM_MACROS:
		text = re.sub(r'^#define %s\b[^\n]*\n' % macro, '', text, flags=re.M)
	text = re.sub(r'^#ifndef _WIN32_WINNT\n#endif\n', '', text, flags=re.M)
	text = re.sub(r'^#if [^\n]*\n#endif\n', '', text, flags=re.M)
	names -= set(macros)
	for new in (prefix + n for n in names):
		if new in used:
			stop('src/%s: the name %s is taken' % (name, new))
	return '\n/* ==== src/%s */\n' % name + renamed(text, prefix, names, known) + ''.join('#undef %s\n' % m for m in macros)


def main():
	out = Path(sys.argv[1] if len(sys.argv) > 1 else 'build/amalgamation')
	public = Path('include/cairn.h').read_text(encoding='utf-8')
	folders = {p.parent.name for p in SOURCE.glob('*/*.c')}
	if folders != set(FOLDERS):
		stop('the folders of src/ are not those of FOLDERS: ' + ' '.join(sorted(folders ^ set(FOLDERS))))
	sources = ['%s/%s' % (f, p.name) for f in FOLDERS for p in sorted((SOURCE / f).glob('*.c'))]
	# windows.h defines macros such as `near`: what includes it comes last.
	sources.sort(key=lambda name: '<windows.h>' in read(name))
	headers = Headers()
	for name in sources:
		for header in INCLUDE.findall(read(name)):
			if header != 'cairn.h':
				headers.load(header)
	order = headers.ordered()
	known = set(re.findall(r'[A-Za-z_]\w*', without_comments(public + ''.join(headers.text[h] for h in order))))
	used = known | {w for name in sources for w in re.findall(r'[A-Za-z_]\w*', read(name))}
	version = '.'.join(re.search(r'CN_VERSION_%s (\d+)' % part, public).group(1) for part in ('MAJOR', 'MINOR', 'PATCH'))
	parts = [PREAMBLE % version, '#include "cairn.h"\n']
	parts += ['\n/* ==== src/%s */\n' % h + INCLUDE.sub('', headers.text[h]) for h in order]
	parts += [source_text(name, headers, known, used) for name in sources]
	out.mkdir(parents=True, exist_ok=True)
	(out / 'cairn.h').write_text(public, encoding='utf-8')
	(out / 'cairn.c').write_text(''.join(parts), encoding='utf-8')


main()
