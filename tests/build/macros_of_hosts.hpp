#pragma once

// Macros in lower case, or short ones, that headers of a host's may leave behind. quell uses none of these names.

// windows.h (with NOMINMAX) and what it includes
#define near
#define far
#define small char
#define hyper long long
#define interface struct
#define cdecl
#define pascal
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define ERROR 0
#define DELETE 0x10000
#define ABSOLUTE 1
#define RELATIVE 2
#define DIFFERENCE 11
#define TRANSPARENT 1
#define OPAQUE 2
#define TRUE 1
#define FALSE 0

// X11/Xlib.h
#define None 0L
#define Bool int
#define True 1
#define False 0
#define Status int
#define Always 2
#define Success 0
#define Complex 0
#define Convex 2
#define Nonconvex 1
#define Above 0
#define Below 1
#define Unsorted 0

// Qt's keywords
#define signals public
#define slots
#define emit
#define foreach for
#define forever for (;;)

// complex.h
#define I 1i
#define complex _Complex
